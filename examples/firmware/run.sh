#!/usr/bin/env bash
# Boots one image in QEMU; its output and exit code are the image's own.
# The board follows from the target in the ELF's path: an image never meets a memory map it was not linked for.
set -euo pipefail

elf=$1
case $elf in
*thumbv7em*) qemu=(qemu-system-arm -M mps2-an386) ;;        # Cortex-M4F, 4 MB + 4 MB
*thumbv6m*) qemu=(qemu-system-arm -M microbit) ;;           # Cortex-M0, the real part's 256 KB + 16 KB
*riscv32*) qemu=(qemu-system-riscv32 -M virt -bios none) ;; # RV32IMAC
*) echo "run.sh: no machine for $elf" >&2; exit 2 ;;
esac

# icount shift=10: every instruction takes 2^10 ns of virtual time, which is 25.6 SysTick periods on the M4F
# and 16.4 on the M0: one instruction is far above the counter's resolution, so a count is exact.
exec timeout 120 "${qemu[@]}" -nographic -monitor none -serial none \
    -semihosting-config enable=on,target=native -icount shift=10 -kernel "$elf"
