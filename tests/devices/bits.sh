# Compares the bits of results on every target.

section "Bits"

# same_bits <label> <file>: checks that the file holds the hashes that the host printed. The tables of TM-30 do not fit
# into the smallest part, but every other group must be there.
same_bits() {
    local expected=$out/bits.expected
    case $1 in
    $m0*) grep -Ev '^(scenes|tm30) ' "$out/bits.host" >"$expected" ;;
    *) cp "$out/bits.host" "$expected" ;;
    esac
    if diff -u --label "host" --label "$1" "$expected" "$2"; then
        pass "$1: the same bits as the host ($(grep -c . "$2") groups)"
    else
        fail "$1: the bits differ from those of the host"
    fi
}

firmware "host" run --quiet --release --bin bits >"$out/bits.host" || exit 1
if [[ $bless == yes ]]; then
    {
        echo "# FNV-1a over the bits of each group in tests/bits/src: the same on every target."
        cat "$out/bits.host"
    } >"$golden_bits"
    echo "recorded in ${golden_bits#"$root"/}"
elif diff -u --label "on record" --label "host" <(grep -sv '^#' "$golden_bits") "$out/bits.host"; then
    pass "host: the bits are those on record"
else
    fail "host: the bits differ from those on record (if the change is meant, run tests/devices.sh --bless)"
fi

if firmware "host, simd" run --quiet --release --bin bits --features simd >"$out/bits.host-simd"; then
    same_bits "host, simd" "$out/bits.host-simd"
fi

# device_bits <target> [cargo arguments]
device_bits() {
    local target=$1 label="$*"
    shift
    can_run "$target" "$label" || return 0
    firmware "$label" build --quiet --profile "$(profile_for "$target")" --bin bits --target "$target" "$@" || return 0
    boot "$label" "$CARGO_TARGET_DIR/$target/$(profile_for "$target")/bits" "$out/bits.device" || return 0
    same_bits "$label" "$out/bits.device"
}
device_bits $m4f --features simd
for target in $boards; do
    device_bits $target
done

# other_bits <architecture> [cargo arguments]: the bits of another processor with Linux, in the emulator of its programs.
other_bits() {
    local target=$1-unknown-linux-gnu label="$1-unknown-linux-gnu, ${*:2}" linker=$1-linux-gnu-gcc variable
    label=${label%, } variable=CARGO_TARGET_${target^^}
    variable=${variable//-/_}
    shift
    if ! have_target "$target"; then
        skip "$label: target $target is not installed (rustup target add $target)"
        return
    elif ! have "$linker"; then
        skip "$label: $linker is not installed"
        return
    elif ! have "qemu-${target%%-*}"; then
        skip "$label: qemu-${target%%-*} (package qemu-user) is not installed"
        return
    fi
    (cd "$root/examples/firmware" && env "${variable}_LINKER=$linker" \
        "${variable}_RUNNER=qemu-${target%%-*} -L /usr/${linker%-gcc}" \
        cargo run --quiet --release --bin bits --target "$target" "$@") >"$out/bits.other" ||
        { fail "$label: does not build, or exits with code $?"; return 0; }
    same_bits "$label" "$out/bits.other"
}
for architecture in aarch64 s390x; do # NEON, and numbers whose first byte is the largest
    other_bits $architecture
    other_bits $architecture --features simd
done

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
