#!/usr/bin/env bash
# Installs voxprite into an empty folder and builds samples/game against it, as a game would: its
# tool must cast the very sprite that the program renders, its assets must be what export makes.
#     game_build.sh SOURCE_DIR BUILD_DIR
set -euo pipefail
source=$1 build=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for component in program library; do
    cmake --install "$build" --prefix "$work/installed" --component $component >/dev/null
done
cmake -S "$source/samples/game" -B "$work/game" -DCMAKE_PREFIX_PATH="$work/installed" \
    -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$work/game" >/dev/null

voxprite=$work/installed/bin/voxprite
model=$source/samples/knight.vox
theirs=$("$work/game/sprite_hash" "$model")
ours=$("$voxprite" render "$model" --ortho --json | grep -A9 '"buffer"' | grep -o '"sha256": *"[0-9a-f]*"')
echo "the game's tool: $theirs"
echo "voxprite render: $ours"
[ "$ours" = "\"sha256\": \"$theirs\"" ]

# OpenVDB's part of the program lies elsewhere than beside it.
"$voxprite" convert "$model" -o "$work/knight.vdb" >/dev/null
"$voxprite" export "$model" -o "$work/knight.svo" >/dev/null
cmp "$work/game/knight.svo" "$work/knight.svo"
for file in share/applications/voxprite.desktop share/mime/packages/voxprite.xml \
    share/icons/hicolor/128x128/apps/voxprite.png; do
    [ -s "$work/installed/$file" ]
done
