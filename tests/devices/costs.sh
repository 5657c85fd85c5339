# Measures the instructions and the stack of calls and the flash of images, and checks what images must not contain.

section "Costs (release is opt-level 3, small is opt-level s)"

costs=$out/costs       # lines "target profile what number unit"
measured=$out/measured # lines "target profile unit" for what could be measured here
: >"$costs" >"$measured"

weights=$((3 * 16 * 4)) # the bytes of the weights of 16 bands
fine_row=$((471 * 4))   # the bytes of one row of a 1 nm table, which no image here may have

# Symbols of formatting, panics and allocators, and of software f64 by the names that the run-time libraries of Arm and
# GCC use.
allocator='rust_alloc|__rg_alloc|__rdl_alloc'
text="4core3fmt|4core9panicking|flt2dec|$allocator"
f64='__aeabi_(d|f2d|i2d|ui2d|l2d|ul2d)|__[a-z]+df([0-9]|si|di|sf2)?$'

# bytes <elf> <section>: prints the size of a section.
bytes() {
    local hex
    hex=$(readelf -SW "$1" | awk -v name="$2" '{ sub(/^ *\[ *[0-9]+\] */, "") } $1 == name { print $5 }')
    echo $((16#${hex:-0}))
}

# lacks <label> <elf> <what> <pattern>: checks that no symbol of the image matches.
lacks() {
    local found
    found=$(nm "$2" | grep -E "$4" | awk '{ print $NF }' || true)
    if [[ -z $found ]]; then
        pass "$1: no $3"
    else
        fail "$1: $3 in the image: ${found//$'\n'/ }"
    fi
}

# no_fine_table <label> <elf>: checks that the largest constant, without the interrupt vectors, is smaller than a row of
# a 1 nm table.
no_fine_table() {
    local largest
    largest=$(nm --print-size "$2" | awk '$3 ~ /^[rRdD]$/ && $4 != "__INTERRUPTS" { print $2 }' | sort | tail -1)
    if ((16#${largest:-0} < fine_row)); then
        pass "$1: no 1 nm table"
    else
        fail "$1: the image has a table of 0x$largest bytes, which may be a 1 nm table"
    fi
}

# frugal <label> <elf>: checks that an image whose linking proves that it cannot panic also lacks what else is costly.
frugal() {
    lacks "$1" "$2" "core::fmt, panic or allocator" "$text"
    lacks "$1" "$2" "software f64" "$f64"
    no_fine_table "$1" "$2"
}

# flash <target> <profile> <image>: measures the flash that an image adds to a program that does nothing.
flash() {
    local images=$CARGO_TARGET_DIR/$1/$2 code tables
    code=$(($(bytes "$images/$3" .text) - $(bytes "$images/empty" .text)))
    tables=$(($(bytes "$images/$3" .rodata) - $(bytes "$images/empty" .rodata)))
    echo "$1 $2 $3-code $code bytes" >>"$costs"
    echo "$1 $2 $3-tables $tables bytes" >>"$costs"
    if ((tables >= fine_row)); then
        fail "$1 $2: $3 has $tables bytes of tables, which could hold a 1 nm table"
    fi
    [[ $3 == fold16 ]] || return 0
    # At opt-level 3 the weights may become literals between the instructions, and are then part of the code.
    if ((code + tables < 3 * fine_row)) && { ((tables == weights)) ||
        { [[ $2 == release ]] && ((tables == 0)); }; }; then
        pass "$1 $2: fold16 has $tables bytes of tables and $code of code"
    else
        fail "$1 $2: fold16 has $tables bytes of tables; it must have $weights"
    fi
}

# inside <target> <profile>: measures and checks the contents of the images.
inside() {
    local label="$1 $2" images=$CARGO_TARGET_DIR/$1/$2 image
    if ! have readelf || ! have nm; then
        skip "$label: the images were not examined, since readelf and nm (binutils) are not installed"
        return
    fi
    for image in $priced; do
        flash "$1" "$2" "$image"
        frugal "$label: $image" "$images/$image"
    done
    echo "$1 $2 bytes" >>"$measured"
    for image in $counting; do
        [[ $image != backends ]] || continue # its backend `Libm` uses software f64
        lacks "$label: $image" "$images/$image" "software f64" "$f64"
    done
    # Both searches must find what exists: `count` prints, and the run-time library has all of software f64.
    nm "$images/count" | grep -E "$text" >/dev/null || fail "$label: the search for core::fmt finds nothing where it must"
    nm "$(rustc --print sysroot)/lib/rustlib/$1/lib/"libcompiler_builtins-*.rlib 2>/dev/null |
        grep -E "$f64" >/dev/null || fail "$label: the search for software f64 finds nothing where it must"
}

# The images that print "what number unit", where no unit means instructions, and those whose flash is measured. Finding
# a spectrum for a color is not counted on the M0, where it takes more instructions than the counter can hold.
counting="count color_count surface_count path_count path_folded yardsticks backends price price_whole"
counting_elsewhere="upsample_count"
priced="fold16 counts_f32 counts_fixed upsample"

# device_costs <target> <profile>: measures everything for one target and profile.
device_costs() {
    local label="$1 $2" image
    can_run "$1" "$label, costs" || return 0
    local images=$counting
    [[ $1 == "$m0" ]] || images="$images $counting_elsewhere"
    measuring "$label" "$1" "$2" empty $images $priced || return 0
    for image in $images; do
        boot "$label" "$CARGO_TARGET_DIR/$1/$2/$image" "$out/count.device" || continue
        awk -v row="$label" '{ print row, $1, $2, $3 ? $3 : "instructions" }' "$out/count.device" >>"$costs"
    done
    echo "$1 $2 instructions" >>"$measured"
    echo "$1 $2 stack-bytes" >>"$measured"
    inside "$1" "$2"
}
for target in $boards; do
    device_costs $target release
    device_costs $target small
done

# The images of calls that put arrays on the stack. Some of them take more instructions than the counter can hold, so
# these images run with a slower one, whose counts are right within 0.5 %.
large="large_rendering large_scenes large_sensor large_spectra"

# in_ram <label> <elf>: checks that the image keeps nothing in RAM, so that its stack is all that it needs.
in_ram() {
    have readelf || { skip "$1: its RAM was not examined, since readelf (binutils) is not installed"; return 0; }
    local ram=$(($(bytes "$2" .data) + $(bytes "$2" .bss) + $(bytes "$2" .uninit)))
    if ((ram == 0)); then
        pass "$1: nothing in RAM but the stack"
    else
        fail "$1: $ram bytes in RAM besides the stack"
    fi
}

# large_costs <target> <profile>: measures the large calls.
large_costs() {
    local label="$1 $2" image shift=3
    [[ $1 != "$m0" ]] || shift=2
    can_run "$1" "$label, large calls" || return 0
    measuring "$label" "$1" "$2" $large || return 0
    for image in $large; do
        in_ram "$label: $image" "$CARGO_TARGET_DIR/$1/$2/$image"
        boot "$label" "$CARGO_TARGET_DIR/$1/$2/$image" "$out/count.device" "$shift" || continue
        awk -v row="$label" '{ print row, $1, $2, $3 }' "$out/count.device" >>"$costs"
    done
}
for target in $m4f $m0; do
    large_costs $target release
    large_costs $target small
done

# no_panic <target> <profile> <image> <feature>: builds an image that links only if nothing in it can panic.
no_panic() {
    local label="$1 $2: $3" elf=$CARGO_TARGET_DIR/$1/$2/$3
    local build=(--quiet --target "$1" --profile "$2" --no-default-features --features "$4" --bin "$3")
    if ! have_target "$1"; then
        skip "$label: target $1 is not installed (rustup target add $1)"
        return
    elif ! (cd "$root/examples/firmware" && cargo build "${build[@]}") 2>"$out/no_panic"; then
        grep -q this_image_can_panic "$out/no_panic" || cat "$out/no_panic"
        fail "$label does not link; these functions can panic: $(who_can_panic "$elf" "${build[@]}")"
        return
    fi
    pass "$label: links without a panic"
    have nm || { skip "$label: nm is not installed"; return 0; }
    lacks "$label" "$elf" "core::fmt, panic or allocator" "$text"
    case $3 in
    *constants) ;; # these compute in f64
    *) lacks "$label" "$elf" "software f64" "$f64" ;;
    esac
}

# who_can_panic <elf> <cargo arguments>: links an image although it can panic, and prints the functions that do.
who_can_panic() {
    local elf=$1
    shift
    (cd "$root/examples/firmware" && cargo rustc "$@" -- -C symbol-mangling-version=v0 -C link-arg=--emit-relocs \
        -C link-arg=--defsym=this_image_can_panic=0) 2>/dev/null || return 0
    # A relocation in the code names what is called there, and a symbol that begins before it is the caller.
    { nm --numeric-sort "$elf" | sed 's/^/symbol /'; readelf --relocs --wide "$elf"; } | awk '
        $1 == "symbol" && $3 ~ /^[tT]$/ && $4 !~ /^\$/ { place[++count] = $2; name[count] = $4 }
        $5 ~ /4core9panicking/ {
            low = 1; high = count
            while (low < high) {
                middle = int((low + high + 1) / 2)
                if (place[middle] <= $1) low = middle; else high = middle - 1
            }
            if (name[low] !~ /4core9panicking/) print name[low]
        }' | sort -u | c++filt
}
for profile in release small; do
    for image in no_panic no_panic_constants; do
        for target in $boards; do
            no_panic $target $profile $image no-panic
        done
    done
done
# What the compiler sees at one level it may not see at another.
for profile in opt-1 opt-2 opt-z; do
    for image in no_panic no_panic_constants; do
        no_panic $m4f $profile $image no-panic
    done
done

# A path of factors must cost as much as a loop by hand, and must not contain code of effects that are not in it.
effects='fluorescen|onaldson|polariz|Polariz|phosphor|Phosphor'
for profile in release small; do
    no_panic $m4f $profile path_plain measure
    label="$m4f $profile: path_plain" images=$CARGO_TARGET_DIR/$m4f/$profile
    if [[ -e $images/path_plain && -e $images/path_count ]] && have nm; then
        lacks "$label" "$images/path_plain" "fluorescence or polarization" "$effects"
        nm "$images/path_count" | grep -E "$effects" >/dev/null ||
            fail "$label: the search for effects finds nothing where it must"
    else
        skip "$label: the search for effects was not made, since the images were not built or nm is not installed"
    fi
done
for what in path-surface path-glass-surface; do
    for row in {$m4f,$m33,$m0,$rv32}" "{release,small}; do
        numbers=$(awk -v row="$row" -v what="$what" '
            $1 " " $2 == row && $3 == what { path = $4 }
            $1 " " $2 == row && $3 == what "-by-hand" { hand = $4 }
            END { if (path && hand) print path, hand }' "$costs")
        read -r path hand <<<"$numbers" || true
        label="$row: $what takes ${path:-?} instructions, by hand ${hand:-?}"
        if [[ -z $numbers ]]; then
            skip "$label (not measured)"
        elif ((path * 100 <= hand * 102 && hand * 100 <= path * 102)); then
            pass "$label"
        else
            fail "$label"
        fi
    done
done

# The examples that users copy must not be costly either. They print or log, so they contain panics and core::fmt.
in_use() {
    local label="$1 release: $2" elf=$CARGO_TARGET_DIR/$1/release/$2
    if ! [[ -e $elf ]] || ! have nm; then
        skip "$label: the image was not built, or nm is not installed"
        return
    fi
    lacks "$label" "$elf" "allocator" "$allocator"
    lacks "$label" "$elf" "software f64" "$f64"
    no_fine_table "$label" "$elf"
}
for target in $boards; do
    in_use $target sensor
    in_use $target driver
done

while read -r target profile what limit unit; do
    [[ -n $target ]] || continue
    number=$(awk -v row="$target $profile" -v what="^$what\$" -v unit="$unit" '
        $1 " " $2 == row && $3 ~ what && $5 == unit { sum += $4; found = 1 }
        END { if (found) print sum }' "$costs")
    label="$target $profile: $what takes ${number:-?} $unit, and at most $limit are allowed"
    if [[ -z $number ]]; then
        skip "$label (not measured)"
    elif ((number <= limit)); then
        pass "$label"
    else
        fail "$label"
    fi
done <<<"$bars"
