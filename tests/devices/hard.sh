# Runs the hard cases on a Cortex-M4F, with subnormal numbers by IEEE 754 and then flushed to zero. Their errors are
# computed from the record on a host (tests/hard).

section "Hard cases"

golden_hard=$root/tests/data/hard_m4f.txt

# Keeps those results of the second run that flushing changes.
what_flushing_changes() {
    awk '$0 == "flush-to-zero" { second = 1; print; next }
        !second { first[$1, $2] = $0; print; next }
        first[$1, $2] != $0'
}

hard_cases() {
    local label="$m4f, hard cases"
    can_run $m4f "$label" || return 0
    firmware "$label" build --quiet --release --bin hard --no-default-features --features measure --target $m4f || return 0
    boot "$label" "$CARGO_TARGET_DIR/$m4f/release/hard" "$out/hard.device" || return 0
    {
        echo "# Row, input, bits of the naive form and of the crate's: the image hard on a Cortex-M4F; after the"
        echo "# line flush-to-zero the results that this changes. By tests/devices.sh --bless."
        what_flushing_changes <"$out/hard.device"
    } >"$out/hard.recorded"
    if [[ $bless == yes ]]; then
        cp "$out/hard.recorded" "$golden_hard"
        echo "recorded in ${golden_hard#"$root"/}"
    elif diff -u --label "on record" --label "$m4f" "$golden_hard" "$out/hard.recorded"; then
        pass "$label: the bits are those on record ($(grep -c . "$out/hard.device") results)"
    else
        fail "$label: the bits differ from those on record (if the change is meant, run tests/devices.sh --bless)"
    fi
}
hard_cases
