#!/usr/bin/env bash
# Proves on devices what the README promises, with QEMU and node in place of the boards:
#   the same bits    every target prints the hashes that the host prints, with and without the feature `simd`
#   so many steps    instructions of public calls, against tests/data/instructions.txt (none may grow by over 2 %)
#   so many bytes    what 16 bands to XYZ cost in flash, against the same file; and no panic, fmt or f64 with them
#
#   tests/devices.sh             checks
#   tests/devices.sh --bless     checks the bars, then records the bits and the numbers of this run
#   tests/devices.sh --install   first installs what is missing (with CI=true it always does)
#
# What this machine cannot run (no QEMU, no target, no node) is listed as SKIPPED and counted, never passed.
set -euo pipefail
export LC_ALL=C

cd "$(dirname "$0")/.."
root=$PWD
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$root/target}/devices
[[ $CARGO_TARGET_DIR == /* ]] || CARGO_TARGET_DIR=$root/$CARGO_TARGET_DIR
# These would replace or join the flags that every build here chooses for itself.
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS CARGO_BUILD_TARGET CARGO_BUILD_RUSTFLAGS

m4f=thumbv7em-none-eabihf
m0=thumbv6m-none-eabi
rv32=riscv32imac-unknown-none-elf
wasm=wasm32-unknown-unknown
golden_bits=$root/tests/data/bits.txt
golden_costs=$root/tests/data/instructions.txt

# The bars on the M4F, whatever is on record: "profile what limit".
bars="
release xyz-16 180
small xyz-16 270
"
weights=$((3 * 16 * 4)) # bytes: what 16 bands need
fine_row=$((471 * 4))   # bytes: one row of a 1 nm table, what they must not need

bless=no install=${CI:-false}
for argument; do
    case $argument in
    --bless) bless=yes ;;
    --install) install=true ;;
    *) echo "usage: tests/devices.sh [--bless] [--install]" >&2; exit 2 ;;
    esac
done

out=$CARGO_TARGET_DIR/out
rm -rf "$out"
mkdir -p "$out"

# --- keeping score --------------------------------------------------------------------------------

passed=0 failed=0 skipped=0
pass() { passed=$((passed + 1)); echo "ok       $*"; }
fail() { failed=$((failed + 1)); echo "FAILED   $*"; }
skip() { skipped=$((skipped + 1)); echo "SKIPPED  $*"; }

have() { command -v "$1" >/dev/null; }
have_target() { [[ -d $(rustc --print sysroot)/lib/rustlib/$1/lib ]]; }

emulator() {
    case $1 in
    riscv32*) echo qemu-system-riscv32 ;;
    *) echo qemu-system-arm ;;
    esac
}

# Why `$1` cannot be built and run here, if so.
missing_for() {
    if ! have_target "$1"; then
        echo "target $1 is not installed (rustup target add $1)"
    elif ! have "$(emulator "$1")"; then
        echo "$(emulator "$1") is not installed"
    fi
}

# --- what is missing ------------------------------------------------------------------------------

# A failed install is not fatal: what needs it is skipped below, and says so.
install() {
    local target sudo=
    [[ $(id -u) == 0 ]] || sudo=sudo
    for target in $m4f $m0 $rv32 $wasm; do
        have_target $target || rustup target add $target || echo "::warning::could not add $target"
    done
    if ! have qemu-system-arm || ! have qemu-system-riscv32 || ! have readelf; then
        # qemu-utils is only recommended, and conflicts with other packages on some images.
        $sudo apt-get update &&
            $sudo apt-get install -y --no-install-recommends qemu-system-arm qemu-system-misc binutils ||
            echo "::warning::could not install QEMU or binutils"
        # Newer releases have RISC-V in a package of its own.
        have qemu-system-riscv32 || $sudo apt-get install -y --no-install-recommends qemu-system-riscv ||
            echo "::warning::could not install QEMU for RISC-V"
    fi
}
if [[ $install == true ]]; then
    install >&2
fi

# --- building and running -------------------------------------------------------------------------

# firmware <label> <cargo arguments>: builds images, or runs one on the host (so what went wrong goes to stderr).
firmware() {
    local label=$1
    shift
    (cd "$root/examples/firmware" && cargo "$@") || { fail "$label does not build" >&2; return 1; }
}

# same_bits <label> <file>: the file holds the hashes that the host printed. The tables of TM-30 do not fit the
# smallest part; every other group must be there.
same_bits() {
    local expected=$out/bits.expected
    case $1 in
    $m0*) grep -v '^tm30 ' "$out/bits.host" >"$expected" ;;
    *) cp "$out/bits.host" "$expected" ;;
    esac
    if diff -u --label "host" --label "$1" "$expected" "$2"; then
        pass "$1: the same bits as the host ($(grep -c . "$2") groups)"
    else
        fail "$1: other bits than the host"
    fi
}

# boot <label> <elf> <file>: runs an image, and its output goes to the file.
boot() {
    "$root/examples/firmware/run.sh" "$2" >"$3" || { fail "$1: $(basename "$2") exits with code $?"; return 1; }
}

section() { echo; echo "$*"; }

# --- the same bits --------------------------------------------------------------------------------

section "Bits"

firmware "host" run --quiet --release --bin bits >"$out/bits.host" || exit 1
if [[ $bless == yes ]]; then
    {
        echo "# FNV-1a over the bits of each group in examples/firmware/src/bits.rs: the same on every target."
        cat "$out/bits.host"
    } >"$golden_bits"
    echo "recorded in ${golden_bits#"$root"/}"
elif diff -u --label "on record" --label "host" <(grep -sv '^#' "$golden_bits") "$out/bits.host"; then
    pass "host: the bits on record"
else
    fail "host: other bits than on record (if meant, run with --bless)"
fi

if firmware "host, simd" run --quiet --release --bin bits --features simd >"$out/bits.host-simd"; then
    same_bits "host, simd" "$out/bits.host-simd"
fi

# device_bits <target> [cargo arguments]
device_bits() {
    local target=$1 label="$*" why
    shift
    why=$(missing_for "$target")
    if [[ -n $why ]]; then
        skip "$label: $why"
        return
    fi
    firmware "$label" build --quiet --release --bin bits --target "$target" "$@" || return 0
    boot "$label" "$CARGO_TARGET_DIR/$target/release/bits" "$out/bits.device" || return 0
    same_bits "$label" "$out/bits.device"
}
device_bits $m4f --features simd
device_bits $m4f
device_bits $m0
device_bits $rv32

# web_bits <label> <rustc flags> [cargo arguments]
web_bits() {
    local label="$wasm, $1" flags=$2
    shift 2
    if ! have_target $wasm; then
        skip "$label: target $wasm is not installed (rustup target add $wasm)"
        return
    elif ! have node; then
        skip "$label: node is not installed"
        return
    fi
    (cd "$root/examples/web" && RUSTFLAGS=$flags cargo build --quiet --release "$@") ||
        { fail "$label does not build"; return 0; }
    node "$root/examples/web/run.mjs" "$CARGO_TARGET_DIR/$wasm/release/nanospectra_web.wasm" >"$out/bits.wasm" ||
        { fail "$label: node exits with code $?"; return 0; }
    same_bits "$label" "$out/bits.wasm"
}
web_bits "plain" ""
web_bits "simd128" "-C target-feature=+simd128"
web_bits "simd128 and the feature simd" "-C target-feature=+simd128" --features simd

# --- instructions and bytes -----------------------------------------------------------------------

section "Costs (release is opt-level 3, small is opt-level s)"

costs=$out/costs       # "target profile what number unit", one a line
measured=$out/measured # "target profile unit", what could be measured here
: >"$costs" >"$measured"

# bytes <elf> <section>
bytes() {
    local hex
    hex=$(readelf -SW "$1" | awk -v name="$2" '{ sub(/^ *\[ *[0-9]+\] */, "") } $1 == name { print $5 }')
    echo $((16#${hex:-0}))
}

# Symbols of formatting and panics; and of soft f64, by the names that Arm's and GCC's run-time libraries use.
text='4core3fmt|4core9panicking|flt2dec|rust_alloc'
f64='__aeabi_(d|f2d|i2d|ui2d|l2d|ul2d)|__[a-z]+df([0-9]|si|di|sf2)?$'

# lacks <label> <elf> <what> <pattern>
lacks() {
    local found
    found=$(nm "$2" | grep -E "$4" | awk '{ print $NF }' || true)
    if [[ -z $found ]]; then
        pass "$1: no $3"
    else
        fail "$1: $3 in the image: ${found//$'\n'/ }"
    fi
}

# flash <target> <profile>: what 16 bands to XYZ adds to a program, and what it must not bring along.
flash() {
    local label="$1 $2" images=$CARGO_TARGET_DIR/$1/$2 code tables largest
    if ! have readelf || ! have nm; then
        skip "$label: no look into the images, readelf and nm (binutils) are not installed"
        return
    fi
    code=$(($(bytes "$images/fold16" .text) - $(bytes "$images/empty" .text)))
    tables=$(($(bytes "$images/fold16" .rodata) - $(bytes "$images/empty" .rodata)))
    echo "$1 $2 fold16-code $code bytes" >>"$costs"
    echo "$1 $2 fold16-tables $tables bytes" >>"$costs"
    echo "$1 $2 bytes" >>"$measured"

    # At opt-level 3 the weights may become literals between the instructions; they are in the code then.
    if ((tables == weights)) || { [[ $2 == release ]] && ((tables == 0)); }; then
        pass "$label: fold16 has $tables bytes of tables and $code of code"
    else
        fail "$label: fold16 has $tables bytes of tables, must be $weights"
    fi
    largest=$(nm --print-size "$images/fold16" | awk '$3 ~ /^[rRdD]$/ { print $2 }' | sort | tail -1)
    if ((code + tables < 3 * fine_row && 16#${largest:-0} < fine_row)); then
        pass "$label: fold16 has no room for a 1 nm table"
    else
        fail "$label: fold16 could hold a 1 nm table ($code + $tables bytes, one of 0x${largest:-0})"
    fi
    lacks "$label: fold16" "$images/fold16" "core::fmt and no panic" "$text"
    lacks "$label: fold16" "$images/fold16" "soft f64" "$f64"
    lacks "$label: count" "$images/count" "soft f64" "$f64"
    # The searches must find what is there: `count` prints, and the run-time library has every soft f64.
    nm "$images/count" | grep -E "$text" >/dev/null || fail "$label: the search for core::fmt is blind"
    nm "$(rustc --print sysroot)/lib/rustlib/$1/lib/"libcompiler_builtins-*.rlib 2>/dev/null |
        grep -E "$f64" >/dev/null || fail "$label: the search for soft f64 is blind"
}

# device_costs <target> <profile>
device_costs() {
    local label="$1 $2" why
    why=$(missing_for "$1")
    if [[ -n $why ]]; then
        skip "$label, costs: $why"
        return
    fi
    firmware "$label" build --quiet --profile "$2" --bin count --bin empty --bin fold16 --target "$1" || return 0
    boot "$label" "$CARGO_TARGET_DIR/$1/$2/count" "$out/count.device" || return 0
    awk -v row="$label" '{ print row, $1, $2, "instructions" }' "$out/count.device" >>"$costs"
    echo "$1 $2 instructions" >>"$measured"
    flash "$1" "$2"
}
for target in $m4f $m0 $rv32; do
    device_costs $target release
    device_costs $target small
done

# Every run-time step in one image: it links only if none of them can panic.
no_panic() {
    local label="$m4f $1, every step in one image" why
    why=$(missing_for $m4f)
    if [[ -n $why ]]; then
        skip "$label: $why"
        return
    fi
    if firmware "$label" build --quiet --profile "$1" --bin no_panic --target $m4f; then
        pass "$label: links without a panic"
        have nm || { skip "$label: nm is not installed"; return; }
        lacks "$label" "$CARGO_TARGET_DIR/$m4f/$1/no_panic" "core::fmt" "$text"
        lacks "$label" "$CARGO_TARGET_DIR/$m4f/$1/no_panic" "soft f64" "$f64"
    fi
}
no_panic release
no_panic small

while read -r profile what limit; do
    [[ -n $profile ]] || continue
    number=$(awk -v row="$m4f $profile $what" '$1 " " $2 " " $3 == row { print $4 }' "$costs")
    if [[ -z $number ]]; then
        skip "$m4f $profile: $what was not counted, bar $limit"
    elif ((number <= limit)); then
        pass "$m4f $profile: $what takes $number instructions, bar $limit"
    else
        fail "$m4f $profile: $what takes $number instructions, bar $limit"
    fi
done <<<"$bars"

# --- against the record ---------------------------------------------------------------------------

if [[ $bless == yes ]]; then
    # What could not be measured here keeps its lines.
    kept=$(cat "$golden_costs" 2>/dev/null | awk '
        /^#/ { next }
        FILENAME == ARGV[1] { ran[$0] = 1; next }
        !(($1 " " $2 " " $5) in ran)' "$measured" -)
    {
        echo "# Instructions of public calls (exact, QEMU with -icount) and bytes of flash that 16 bands to XYZ add"
        echo "# to a program; release is opt-level 3, small is opt-level s. By tests/devices.sh --bless with"
        echo "# $(rustc --version)"
        { cat "$costs"; echo "$kept"; } | grep . | sort -k1,1r -k2,2 -s
    } >"$golden_costs.new"
    mv "$golden_costs.new" "$golden_costs"
    echo "recorded in ${golden_costs#"$root"/}"
else
    [[ -f $golden_costs ]] || fail "nothing is on record in ${golden_costs#"$root"/}"
    # Prints every change; "grown", "gone" and "new" are failures.
    awk '
        /^#/ { next }
        FILENAME == ARGV[1] { ran[$0] = 1; next }
        { key = $1 " " $2 " " $3 }
        FILENAME == ARGV[2] { old[key] = $4; unit[key] = $5; next }
        {
            seen[key] = 1
            if (!(key in old)) print "new", key ": " $4, $5 ", not on record"
            else if ($4 > old[key] * 1.02) print "grown", key ": " old[key] " -> " $4, $5
            else if ($4 != old[key]) print "moved", key ": " old[key] " -> " $4, $5
        }
        END {
            for (key in old) {
                split(key, part, " ")
                if (key in seen || !((part[1] " " part[2] " " unit[key]) in ran)) continue
                print "gone", key ": was " old[key], unit[key]
            }
        }' "$measured" <(cat "$golden_costs" 2>/dev/null) "$costs" | sort >"$out/changes"
    while read -r verdict change; do
        case $verdict in
        moved) echo "changed  $change" ;;
        *) fail "$verdict: $change" ;;
        esac
    done <"$out/changes"
    if grep -qvE '^moved' "$out/changes"; then
        echo "on record by $(grep -s '^# rustc' "$golden_costs"), now by $(rustc --version)"
        echo "if the change is meant, run tests/devices.sh --bless"
    elif [[ -s $measured ]]; then
        pass "no number on record has grown by more than 2 % ($(grep -c . "$costs") numbers)"
    fi
fi

section "devices: $passed ok, $failed FAILED, $skipped SKIPPED"
if ((skipped > 0)) && [[ ${CI:-} == true ]]; then
    echo "::warning::tests/devices.sh skipped $skipped checks, see its output"
fi
((failed == 0))
