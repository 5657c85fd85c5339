# Prints the numbers on record as tables.

# prices <file>: prints the instructions of each call on each core as "release / small", then stack and flash likewise,
# then the functions of each math backend on each core.
prices() {
    local unit target
    for unit in instructions stack-bytes bytes; do
        awk -v unit=$unit -v cores="$m4f $m33 $m0 $rv32" '
            BEGIN {
                title["instructions"] = "instructions"
                title["stack-bytes"] = "bytes of stack"
                title["bytes"] = "bytes of flash"
                count = split(cores, core, " ")
            }
            /^#/ || $5 != unit || $3 ~ /^math-.*-/ { next }
            # The code and the tables of an image are added up.
            { what = $3; sub(/-(code|tables)$/, "", what) }
            !(what in known) { known[what] = 1; name[++names] = what }
            { price[what, $1, $2] += $4; has[what, $1, $2] = 1 }
            function cell(what, core, profile) { return (what, core, profile) in has ? price[what, core, profile] : "-" }
            END {
                print "| " title[unit] ", fast / small | Cortex-M4F | Cortex-M33 | Cortex-M0 | RV32IMAC |"
                print "|---|---:|---:|---:|---:|"
                for (n = 1; n <= names; n++) {
                    row = "| `" name[n] "` |"
                    for (c = 1; c <= count; c++)
                        row = row " " cell(name[n], core[c], "release") " / " cell(name[n], core[c], "small") " |"
                    print row
                }
                print ""
            }' "$1"
    done
    for target in $boards; do
        awk -v core=$target '
            BEGIN { count = split("fast portable libm micromath", backend, " ") }
            $1 != core || !match($3, /^math-.*-/) { next }
            { what = substr($3, 7, RLENGTH - 7); by = substr($3, RLENGTH + 1) }
            !(what in known) { known[what] = 1; name[++names] = what }
            { price[what, by, $2] = $4 }
            END {
                print "| instructions on " core ", fast / small | `Fast` | `Portable` | `Libm` | `Micromath` |"
                print "|---|---:|---:|---:|---:|"
                for (n = 1; n <= names; n++) {
                    row = "| " name[n] " |"
                    for (b = 1; b <= count; b++)
                        row = row " " price[name[n], backend[b], "release"] " / " price[name[n], backend[b], "small"] " |"
                    print row
                }
                print ""
            }' "$1"
    done
}
