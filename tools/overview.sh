#!/usr/bin/env bash
# Makes the pictures of README.md and src/narrow/GJK.md from a build of tumble and puts them into scenes/pictures:
#   overview.png  nine of the shipped scenes, three by three
#   demo.gif      a scene in motion, as a loop
#   gjk_*.png     the iterations of GJK for three pairs of shapes
#
#   tools/overview.sh            with build/release/tools/tumble
#   tools/overview.sh TUMBLE     with that binary
#
# Needs ffmpeg, which setup.sh installs for the tests. The same binary and the same ffmpeg make the same files.
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
pictures=$project/scenes/pictures

say() { echo "overview: $*" >&2; }
die() { say "$@"; exit 1; }

(($# <= 1)) || { echo "usage: ${0##*/} [TUMBLE]" >&2; exit 2; }
tumble=${1-$project/build/release/tools/tumble}
[[ -x $tumble ]] || die "no tumble binary at $tumble: build it with tools/run.sh, or name another"
type -P ffmpeg > /dev/null || die "ffmpeg is missing (Debian: apt-get install --no-install-recommends ffmpeg)"

work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# The scenes of the overview, row by row: NAME TIME CENTER_X CENTER_Y HEIGHT, the camera in metres.
overview_scenes=(
    'letters 0.8 0 4.8 8.8'
    'hourglass 2.3 0 0 16'
    'wrecking_ball 2 2.2 7.4 18.6'
    'gears 2.5 0.6 -0.8 8.4'
    'ragdoll_pile 1.4 0 2.6 7'
    'walker 3 -0.2 3 10'
    'rope_bridge 2.3 0 0.6 10'
    'washing_machine 5 0 0 12.4'
    'mixed_rain 2.4 0 5.6 18'
)
tile_width=640
tile_height=360
gutter=4

# draw_tile FILE SCENE TIME X Y HEIGHT
draw_tile() {
    "$tumble" shot "$project/scenes/$2.json" --at "$3" --size "${tile_width}x$tile_height" -o "$1" \
        --set "/camera={\"center\": [$4, $5], \"height\": $6}" > /dev/null
}

draw_overview() {
    local i column row layout='' tile inputs=()
    for i in "${!overview_scenes[@]}"; do
        read -ra tile <<< "${overview_scenes[i]}"
        draw_tile "$work/tile_$i.png" "${tile[@]}"
        inputs+=(-i "$work/tile_$i.png")
        column=$((i % 3)) row=$((i / 3))
        layout+=${layout:+|}$((column * (tile_width + gutter)))_$((row * (tile_height + gutter)))
    done
    ffmpeg -v error "${inputs[@]}" -bitexact -pred mixed -compression_level 9 -frames:v 1 \
        -filter_complex "xstack=inputs=${#overview_scenes[@]}:layout=$layout:fill=white,format=rgb24" \
        "$work/overview.png"
}

# The loop begins when the ball has swung half way, and repeats its last frame for 0.6 s.
draw_demo() {
    local fps=20 first_frame=20
    "$tumble" run "$project/scenes/wrecking_ball.json" --duration 4.8 --fps "$fps" --size 480x270 -o "$work/run" \
        --set '/camera={"center": [3.4, 7.4], "height": 20.4}' > /dev/null
    ffmpeg -v error -framerate "$fps" -start_number "$first_frame" -i "$work/run/frames/frame_%06d.png" -bitexact \
        -filter_complex "tpad=stop_mode=clone:stop_duration=0.6,split[a][b];
            [a]palettegen=stats_mode=full:max_colors=128[palette];
            [b][palette]paletteuse=dither=none:diff_mode=rectangle" \
        -loop 0 "$work/demo.gif"
}

# draw_trace NAME A B
draw_trace() {
    "$tumble" distance "$2" "$3" --sub-algorithm voronoi --trace "$work/gjk_$1.png" > /dev/null
}

# draw_kite NAME Y: the pentagon and the kite of src/narrow/GJK.md, the kite at that height.
draw_kite() {
    local pentagon='[[-1, -0.6], [0.8, -0.9], [1.2, 0.1], [0.2, 0.9], [-0.9, 0.6]]'
    local kite='[[-1.4, 0.1], [0, -0.5], [1.4, 0.2], [0, 0.6]]'
    draw_trace "$1" "{\"polygon\": {\"vertices\": $pentagon}}" \
        "{\"polygon\": {\"vertices\": $kite}, \"pose\": {\"position\": [0.9, $2], \"angle\": 20}}"
}

# publish NAME MOST_KILOBYTES: moves a finished picture to scenes/pictures.
publish() {
    local size
    size=$(($(stat -c %s -- "$work/$1") / 1000))
    ((size <= $2)) || die "$1 has $size kB, more than $2"
    mv -- "$work/$1" "$pictures/$1"
    say "$pictures/$1, $size kB"
}

draw_overview
draw_demo
draw_kite apart 1.9
draw_kite overlap 0.9
draw_trace rounded '{"box": {"size": [2, 1], "radius": 0.2}}' \
    '{"capsule": {"from": [-1, 0], "to": [1, 0], "radius": 0.3}, "pose": {"position": [1.9, 1.2], "angle": -50}}'
publish overview.png 600
publish demo.gif 700
for name in apart overlap rounded; do publish "gjk_$name.png" 200; done
