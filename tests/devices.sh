#!/usr/bin/env bash
# Tests on emulated devices what the documentation promises. QEMU stands for the boards, and node for a browser:
#   bits           every target prints the same hashes as the host, with and without the feature `simd`; so do
#                  programs for aarch64 and for s390x, which is big-endian
#   meaning        one test file passes on the host and on every board, the log of an instrument is complete, and a
#                  published driver reads a simulated chip
#   instructions   public calls take as many as on record in tests/data/instructions.txt, within 2 % in both directions
#   bytes          flash and stack, also of large calls such as `tm30`, are as in the same file, and images contain no panic, core::fmt, allocator or f64
#
#   tests/devices.sh             checks
#   tests/devices.sh --bless     checks the limits, then records the bits and the numbers of this run
#   tests/devices.sh --install   first installs what is missing (always with CI=true)
#   tests/devices.sh --prices    only prints the numbers on record as tables
#
# A check that this machine cannot run, for lack of QEMU, a target or node, is listed and counted as SKIPPED.
set -euo pipefail
export LC_ALL=C

cd "$(dirname "$0")/.."
root=$PWD
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$root/target}/devices
[[ $CARGO_TARGET_DIR == /* ]] || CARGO_TARGET_DIR=$root/$CARGO_TARGET_DIR
# The compiler is that of the records, unless another is asked for.
export RUSTUP_TOOLCHAIN=${RUSTUP_TOOLCHAIN:-$(sed -n 's/.*OF_RECORDS: &str = "\(.*\)";/\1/p' tests/xtask/src/toolchain.rs)}
# These variables would change the flags that each build chooses here.
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS CARGO_BUILD_TARGET CARGO_BUILD_RUSTFLAGS

m4f=thumbv7em-none-eabihf
m33=thumbv8m.main-none-eabihf
m0=thumbv6m-none-eabi
rv32=riscv32imac-unknown-none-elf
wasm=wasm32-unknown-unknown
boards="$m4f $m33 $m0 $rv32"
others="aarch64-unknown-linux-gnu s390x-unknown-linux-gnu"
golden_bits=$root/tests/data/bits.txt
golden_costs=$root/tests/data/instructions.txt

# The limits, which hold whatever is on record, as "target profile what limit unit". `what` is a pattern, and the
# numbers of all names that it matches are added up.
bars="
$m4f release xyz-16 180 instructions
$m4f small xyz-16 270 instructions
$m4f release counts-f32 450 instructions
$m4f release counts-f32 256 stack-bytes
$m4f small counts-f32 256 stack-bytes
$m4f small counts_f32-(code|tables) 2048 bytes
$m4f release upsample-cubic-31-most 10000 instructions
$m4f small upsample-cubic-31-most 16000 instructions
$m4f release upsample-linear-31-most 10000 instructions
$m4f small upsample-linear-31-most 16000 instructions
$m4f small upsample-(code|tables) 2560 bytes
$m4f release path-vest-folded 350 instructions
$m4f release tm30 12000 stack-bytes
$m4f small tm30 12000 stack-bytes
$m4f release cri 2500 stack-bytes
$m4f small cri 2500 stack-bytes
$m0 release tm30 12000 stack-bytes
$m0 small tm30 12000 stack-bytes
$m0 release cri 2500 stack-bytes
$m0 small cri 2500 stack-bytes
$m0 release fixed-counts-xyz-lux 600 instructions
$m0 small fixed-counts-xyz-lux 600 instructions
$m0 release fixed-counts-cct-duv 4000 instructions
$m0 small fixed-counts-cct-duv 4000 instructions
$m0 release fixed-xyz-81 1600 instructions
$m0 small fixed-xyz-81 1600 instructions
"

bless=no install=${CI:-false} prices=no
for argument; do
    case $argument in
    --bless) bless=yes ;;
    --install) install=true ;;
    --prices) prices=yes ;;
    *) echo "usage: tests/devices.sh [--bless] [--install] [--prices]" >&2; exit 2 ;;
    esac
done

source tests/devices/prices.sh
if [[ $prices == yes ]]; then
    prices "$golden_costs"
    exit
fi

out=$CARGO_TARGET_DIR/out
rm -rf "$out"
mkdir -p "$out"

source tests/devices/run.sh
if [[ $install == true ]]; then
    install >&2
fi
source tests/devices/bits.sh
source tests/devices/hard.sh
source tests/devices/meaning.sh
source tests/devices/costs.sh
source tests/devices/record.sh

section "devices: $passed ok, $failed FAILED, $skipped SKIPPED (after $SECONDS s)"
if ((skipped > 0)) && [[ ${CI:-} == true ]]; then
    echo "::warning::tests/devices.sh skipped $skipped checks; its output says why"
fi
((failed == 0))
