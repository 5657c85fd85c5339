# Tests the results of readings: one test file on the host and on every board, the log of an instrument, and a driver on
# a simulated bus.

section "Meaning"

# on_target <label> <profile> [cargo arguments]
on_target() {
    local label=$1 profile=$2
    shift 2
    if (cd "$root/examples/firmware" && cargo test --quiet --profile "$profile" --test on_target "$@") >"$out/on_target" 2>&1
    then
        pass "$label: tests/on_target.rs, $(grep '^on_target:' "$out/on_target")"
    else
        cat "$out/on_target"
        fail "$label: tests/on_target.rs"
    fi
}

# image <label> <name> <file> [cargo arguments]: runs an image by cargo, as a user does, and writes its output to a file.
image() {
    local label=$1 name=$2 file=$3
    shift 3
    (cd "$root/examples/firmware" && cargo run --quiet --release --bin "$name" "$@") >"$file" ||
        { fail "$label: $name exits with code $?"; return 1; }
}

on_target "host" release
if image "host" driver "$out/driver.host"; then
    pass "host: driver, $(cat "$out/driver.host")"
fi
for target in $boards; do
    can_run $target "$target, meaning" || continue
    on_target $target "$(profile_for $target)" --target $target
    if image $target driver "$out/driver.$target" --target $target; then
        if diff "$out/driver.host" "$out/driver.$target"; then
            pass "$target: driver prints the same as on the host"
        else
            fail "$target: driver does not print the same as on the host"
        fi
    fi
    # The log of the first board is shown, and those of the others must be equal to it.
    if image $target sensor "$out/log.$target" --target $target; then
        [[ -s $out/log ]] || { sed 's/^/    /' "$out/log.$target"; cp "$out/log.$target" "$out/log"; }
        if grep -q 'lx, Near' "$out/log" && diff "$out/log" "$out/log.$target"; then
            pass "$target: sensor logs $(grep -c . "$out/log.$target") lines by defmt, as on every board"
        else
            fail "$target: sensor logs nothing, or not the same lines as the first board"
        fi
    fi
done

# This checks that a failing check is noticed.
if can_run $m4f "$m4f, a check that must fail"; then
    if (cd "$root/examples/firmware" && MUST_FAIL=1 cargo test --quiet --release --test on_target --target $m4f) \
        >"$out/must_fail" 2>&1; then
        fail "$m4f: a check that fails is not noticed"
    elif grep -q '^FAILED   nothing is asked to fail' "$out/must_fail"; then
        pass "$m4f: a check that fails is noticed"
    else
        cat "$out/must_fail"
        fail "$m4f: another check failed than the one that must"
    fi
fi
