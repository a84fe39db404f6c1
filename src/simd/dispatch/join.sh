#!/bin/sh
# Joins the objects of the rooms that are compiled once for each instruction set, so that the program chooses at start:
#   join.sh COMPILER LINKER NM OBJCOPY FOLDER NAME...
# FOLDER/NAME.list has the objects of one instruction set, one a line. The first NAME is the baseline.
#
# For each set this writes FOLDER/NAME.o, whose only global symbol is tumble_entries_NAME, the table of the addresses of
# its functions. All other symbols become local: inline functions and templates of one set (of Eigen, of std) cannot
# replace those of another, as the linker's merging of equal names would do. FOLDER/jumps.o defines each function once
# more, as a jump through the table tumble_entries, which tumble_choose_instruction_set() fills before static
# initialisation.
set -eu

compiler=$1 linker=$2 nm=$3 objcopy=$4 folder=$5
shift 5
baseline=$1

die() { echo "join.sh: $*" >&2; exit 1; }

# symbols NAME TYPES: the strong global symbols of these types, of all objects.
symbols() {
    xargs "$nm" --defined-only --extern-only --no-sort < "$folder/$1.list" |
        awk -v types="$2" 'NF == 3 && index(types, $2) { print $3 }' | LC_ALL=C sort
}

symbols "$baseline" T > "$folder/entries"

for name; do
    data=$(symbols "$name" BDGRSC)
    [ -z "$data" ] || die "$name: global variables would exist once for each instruction set: $data"
    symbols "$name" T | cmp -s - "$folder/entries" || die "$name has other functions than $baseline"
    {
        echo ".section .data.rel.ro,\"aw\"
.p2align 3
.globl tumble_entries_$name
.hidden tumble_entries_$name
tumble_entries_$name:"
        sed 's/^/.quad /' "$folder/entries"
        echo '.section .note.GNU-stack,"",@progbits'
    } > "$folder/$name.s"
    "$compiler" -c -o "$folder/$name.table.o" "$folder/$name.s"
    # Without groups, as the linker would keep the group of one set only.
    # shellcheck disable=SC2046  # one word an object
    "$linker" -r --force-group-allocation -o "$folder/$name.all.o" $(cat "$folder/$name.list") "$folder/$name.table.o"
    # objcopy cannot make unique symbols (constants of inline functions) local: they get a name of their own.
    "$nm" --defined-only --extern-only "$folder/$name.all.o" |
        awk -v set="$name" '$2 == "u" { print $3, $3 "." set }' > "$folder/$name.unique"
    "$objcopy" --keep-global-symbol="tumble_entries_$name" --redefine-syms="$folder/$name.unique" \
        "$folder/$name.all.o" "$folder/$name.o"
    rm "$folder/$name.all.o" "$folder/$name.table.o"
done

{
    echo '.text'
    awk '{ printf ".p2align 3\n.globl %s\n.hidden %s\n.type %s, @function\n%s: jmp *tumble_entries+%d(%%rip)\n",
                  $1, $1, $1, $1, 8 * (NR - 1) }' "$folder/entries"
    count=$(wc -l < "$folder/entries")
    echo ".section .rodata
.p2align 3
.globl tumble_entry_count
.hidden tumble_entry_count
tumble_entry_count: .quad $count
.bss
.p2align 3
.globl tumble_entries
.hidden tumble_entries
tumble_entries: .zero $((8 * count))
.section .init_array.00101,\"aw\",@init_array
.p2align 3
.quad tumble_choose_instruction_set
.section .note.GNU-stack,\"\",@progbits"
} > "$folder/jumps.s"
"$compiler" -c -o "$folder/jumps.o" "$folder/jumps.s"
