# Compares the numbers of this run with those on record.

section "Record"

if [[ $bless == yes ]]; then
    # Numbers that could not be measured here keep their lines.
    kept=$(cat "$golden_costs" 2>/dev/null | awk '
        /^#/ { next }
        FILENAME == ARGV[1] { ran[$0] = 1; next }
        !(($1 " " $2 " " $5) in ran)' "$measured" -)
    {
        echo "# Instructions of public calls (exact, QEMU with -icount), the bytes of stack they take, and the bytes of"
        echo "# flash that images add to an empty one; release is opt-level 3, small is opt-level s. By"
        echo "# tests/devices.sh --bless with"
        echo "# $(rustc --version)"
        { cat "$costs"; echo "$kept"; } | grep . | sort -k1,1r -k2,2 -s
    } >"$golden_costs.new"
    mv "$golden_costs.new" "$golden_costs"
    echo "recorded in ${golden_costs#"$root"/}"
else
    [[ -f $golden_costs ]] || fail "nothing is on record in ${golden_costs#"$root"/}"
    # Every change is printed, and all but "moved" are failures. "stale" is one as well, since the number could otherwise
    # grow back without notice.
    awk '
        /^#/ { next }
        FILENAME == ARGV[1] { ran[$0] = 1; next }
        { key = $1 " " $2 " " $3 " " $5 }
        FILENAME == ARGV[2] { old[key] = $4; next }
        {
            seen[key] = 1
            if (!(key in old)) print "new", key ": " $4 " is not on record"
            else if ($4 > old[key] * 1.02) print "grown", key ": " old[key] " -> " $4
            else if (old[key] > $4 * 1.02) print "stale", key ": " old[key] " -> " $4 ", which is less by over 2 %"
            else if ($4 != old[key]) print "moved", key ": " old[key] " -> " $4
        }
        END {
            for (key in old) {
                split(key, part, " ")
                if (key in seen || !((part[1] " " part[2] " " part[4]) in ran)) continue
                print "gone", key ": it was " old[key] " and was not measured now"
            }
        }' "$measured" <(cat "$golden_costs" 2>/dev/null) "$costs" | sort >"$out/changes"
    while read -r verdict change; do
        case $verdict in
        moved) echo "changed  $change" ;;
        *) fail "$verdict: $change" ;;
        esac
    done <"$out/changes"
    if grep -qvE '^moved' "$out/changes"; then
        echo "the record was made by $(grep -s '^# rustc' "$golden_costs"), and this run by $(rustc --version)"
        echo "if the change is meant, run tests/devices.sh --bless"
    elif [[ -s $measured ]]; then
        pass "every number is within 2 % of the record ($(grep -c . "$costs") numbers)"
    fi
fi
