# Counts results, installs, builds and runs images, for all parts of tests/devices.sh.

passed=0 failed=0 skipped=0
pass() { passed=$((passed + 1)); echo "ok       $*"; }
fail() { failed=$((failed + 1)); echo "FAILED   $*"; }
skip() { skipped=$((skipped + 1)); echo "SKIPPED  $*"; }
section() { echo; echo "$*"; }

have() { command -v "$1" >/dev/null; }
have_target() { [[ -d $(rustc --print sysroot)/lib/rustlib/$1/lib ]]; }

emulator() {
    case $1 in
    riscv32*) echo qemu-system-riscv32 ;;
    *) echo qemu-system-arm ;;
    esac
}

# can_run <target> <label>: succeeds if `target` can be built and run here; otherwise reports it as skipped and says why.
can_run() {
    if ! have_target "$1"; then
        skip "$2: target $1 is not installed (rustup target add $1)"
    elif ! have "$(emulator "$1")"; then
        skip "$2: $(emulator "$1") is not installed"
    else
        return 0
    fi
    return 1
}

# profile_for <target>: prints the profile of images that contain everything. At opt-level 3 such an image with software
# floats does not fit into the 256 KB of the smallest part.
profile_for() {
    case $1 in
    $m0) echo small ;;
    *) echo release ;;
    esac
}

# Installs what is missing. If that fails, the checks that need it are reported as skipped.
install() {
    local target sudo=
    [[ $(id -u) == 0 ]] || sudo=sudo
    for target in $boards $wasm $others; do
        have_target $target || rustup target add $target || echo "::warning::could not add $target"
    done
    if ! have qemu-s390x || ! have aarch64-linux-gnu-gcc || ! have s390x-linux-gnu-gcc; then
        # Without recommended packages the compilers lack the files of the C library.
        $sudo apt-get update &&
            $sudo apt-get install -y --no-install-recommends qemu-user gcc-{aarch64,s390x}-linux-gnu \
                libc6-dev-{arm64,s390x}-cross ||
            echo "::warning::could not install QEMU and linkers for other processors"
    fi
    if ! have qemu-system-arm || ! have qemu-system-riscv32 || ! have readelf; then
        # Recommended packages are left out, since qemu-utils conflicts with other packages on some systems.
        $sudo apt-get update &&
            $sudo apt-get install -y --no-install-recommends qemu-system-arm qemu-system-misc binutils ||
            echo "::warning::could not install QEMU or binutils"
        # Newer releases have the emulator for RISC-V in a package of its own.
        have qemu-system-riscv32 || $sudo apt-get install -y --no-install-recommends qemu-system-riscv ||
            echo "::warning::could not install QEMU for RISC-V"
    fi
}

# firmware <label> <cargo arguments>: builds images, or runs one on the host. Failures go to stderr, since stdout may be
# the output of an image.
firmware() {
    local label=$1
    shift
    (cd "$root/examples/firmware" && cargo "$@") || { fail "$label does not build" >&2; return 1; }
}

# measuring <label> <target> <profile> <image>...: builds images that measure, without the features that only other
# images need.
measuring() {
    local label=$1 target=$2 profile=$3
    shift 3
    firmware "$label" build --quiet --target "$target" --profile "$profile" \
        --no-default-features --features measure "${@/#/--bin=}"
}

# boot <label> <elf> <file> [shift]: runs an image in QEMU and writes its output to the file.
boot() {
    "$root/examples/firmware/run.sh" "$2" "${4:-10}" >"$3" || { fail "$1: $(basename "$2") exits with code $?"; return 1; }
}
