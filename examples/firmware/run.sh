#!/usr/bin/env bash
# Boots one image in QEMU; its output and exit code are the image's own.
# The board follows from the target in the ELF's path: an image never meets a memory map it was not linked for.
set -euo pipefail

elf=$1
here=$(dirname "${BASH_SOURCE[0]}")
case $elf in
*thumbv7em*) qemu=(qemu-system-arm -M mps2-an386) ;;        # Cortex-M4F, 4 MB + 4 MB
*thumbv8m.main*) qemu=(qemu-system-arm -M mps2-an505) ;;    # Cortex-M33, the same
*thumbv6m*) qemu=(qemu-system-arm -M microbit) ;;           # Cortex-M0, the real part's 256 KB + 16 KB
*riscv32*) qemu=(qemu-system-riscv32 -M virt -bios none) ;; # RV32IMAC
*) echo "run.sh: no machine for $elf" >&2; exit 2 ;;
esac

# icount shift=10: every instruction takes 2^10 ns of virtual time, which is 25.6 SysTick periods on the M4F, 20.5 on
# the M33 and 16.4 on the M0: one instruction is far above the counter's resolution, so a count is exact.
boot() {
    timeout 120 "${qemu[@]}" -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -icount shift=10 -kernel "$elf"
}

# An image that logs by defmt sends numbers only; the words are in its ELF.
if grep -q __DEFMT_MARKER_END "$elf"; then
    decoder=(env -u CARGO_BUILD_TARGET cargo run --quiet
        --manifest-path "$here/decode/Cargo.toml" --target-dir "${CARGO_TARGET_DIR:-$here/target}" -- "$elf")
    boot | "${decoder[@]}"
else
    boot
fi
