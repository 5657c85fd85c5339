#!/usr/bin/env bash
# Boots one image in QEMU: run.sh <elf> [shift]. The output and the exit code are those of the image.
# The target in the path of the ELF decides on the board, so that the memory map is always the right one.
set -euo pipefail

elf=$1 shift=${2:-10}
here=$(dirname "${BASH_SOURCE[0]}")
case $elf in
*thumbv7em*) qemu=(qemu-system-arm -M mps2-an386) ;;        # Cortex-M4F, 4 MB + 4 MB
*thumbv8m.main*) qemu=(qemu-system-arm -M mps2-an505) ;;    # Cortex-M33, the same
*thumbv6m*) qemu=(qemu-system-arm -M microbit) ;;           # Cortex-M0, the real part's 256 KB + 16 KB
*riscv32*) qemu=(qemu-system-riscv32 -M virt -bios none) ;; # RV32IMAC
*) echo "run.sh: no machine for $elf" >&2; exit 2 ;;
esac

# With icount shift=10, every instruction takes 2^10 ns of virtual time, which is 25.6 periods of SysTick on the M4F,
# 20.5 on the M33 and 16.4 on the M0. One instruction is far above the resolution of the counter, so counts are exact.
# With shift=3 or 2, counts are right within 0.5 % only, but the counter holds 80 or 160 million instructions and more.
boot() {
    timeout 120 "${qemu[@]}" -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native -icount "shift=$shift" -kernel "$elf"
}

# An image that logs by defmt sends only numbers, and the texts are in its ELF.
if grep -q __DEFMT_MARKER_END "$elf"; then
    decoder=(env -u CARGO_BUILD_TARGET cargo run --quiet
        --manifest-path "$here/decode/Cargo.toml" --target-dir "${CARGO_TARGET_DIR:-$here/target}" -- "$elf")
    boot | "${decoder[@]}"
else
    boot
fi
