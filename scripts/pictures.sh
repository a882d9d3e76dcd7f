#!/usr/bin/env bash
# Draws all pictures of the documentation into docs/images, with the scenes as they are now.
#
#   scripts/pictures.sh             builds the fumetto command and draws with it
#   scripts/pictures.sh COMMAND     draws with this one, as in scripts/pictures.sh target/release/fumetto
cd "$(dirname "$0")/.." && . scripts/common.sh

fumetto="${1:-}"
if [ -z "$fumetto" ]; then
    scripts/setup.sh
    say "Building fumetto; the first time takes some minutes."
    cargo build --release --package fumetto-cli
    fumetto="${CARGO_TARGET_DIR:-target}/release/fumetto"
fi

images=docs/images
mkdir -p "$images"
temporary=$(mktemp -d)
trap 'rm -rf "$temporary"' EXIT

# draw SCENE NAME FLAGS...: scenes/SCENE.toml to NAME, a .png or .gif.
draw() {
    local scene="$1" name="$2"
    shift 2
    "$fumetto" render "scenes/$scene.toml" -o "$images/$name" "$@"
}

large=(--size 640x360)
small=(--size 480x270)

# The gallery.
draw chimney chimney.png --frame 144 "${large[@]}"
draw lamp lamp.png --frame 150 "${large[@]}"
draw explosion explosion.png --frame 16 "${large[@]}"
# Layers come beside it: cumulus.normal.png and its kin.
draw cumulus cumulus.png --layers normal,depth,id,alpha,ink "${large[@]}"
draw cottage cottage.png "${large[@]}"
draw cloud cloud.png "${large[@]}"
draw genie genie.png --frame 150 "${large[@]}"
draw cloud-cel cloud-cel.png "${large[@]}"
draw smoke-cel smoke-cel.png --frame 180 "${large[@]}"
draw cloud-transparent cloud-transparent.png "${large[@]}"
draw rings rings.png --frame 60 "${large[@]}"
draw chimney-wind chimney-wind.png --frame 130 "${large[@]}"
draw obstacle obstacle.png --frame 30 "${large[@]}"
draw explosion-grid explosion-grid.png --frame 24 "${large[@]}"
draw metamorphosis metamorphosis.png --frame 60 "${large[@]}"
draw shell shell.png --size 400x540
draw cloud-shadow cloud-shadow.png "${large[@]}"
draw storm storm.png "${large[@]}"
draw puff-fuzzy puff-fuzzy.png "${large[@]}"
draw engraving engraving.png --size 960x540 # strokes want room
draw paint paint.png --frame 100 "${large[@]}"
draw paint-wash paint-wash.png --frame 143 "${large[@]}"
draw paint-pour paint-pour.png --frame 130 "${large[@]}"
draw paint-hill paint-hill.png --frame 100 "${large[@]}"
draw paint-rain paint-rain.png --frame 110 "${large[@]}"
draw paint-powder paint-powder.png --frame 56 "${large[@]}"
draw soft-shadow soft-shadow.png "${large[@]}"
draw day-night day-night.png --frame 84 "${large[@]}"
draw sketch sketch.png "${large[@]}"
draw cloud-ink cloud-ink.png "${large[@]}"
draw smoke-sketch smoke-sketch.png --frame 150 "${large[@]}"
draw chimney chimney.gif --frames 144..191 --size 320x180
draw paint paint.gif --frames 12..83 --size 240x135
draw paint-hill paint-hill.gif --frames 0..119 --size 320x180

# The first scene of README.md, as it stands there, and two ways for its smoke to end.
first="$temporary/first.toml"
sed -n '/^```toml$/,/^```$/{/^```/!p;}' README.md >"$first"
"$fumetto" render "$first" -o "$images/first.png" "${small[@]}"
"$fumetto" render "$first" -o "$images/dissolve-opacity.png" "${small[@]}" \
    --set object.smoke.emitter.erosion_over_life=0 \
    --set 'object.smoke.emitter.opacity_over_life=[[0.5, 1], [1, 0]]'

# A puff in every preset.
draw styles styles.png

# One setting at a time, on the same cloud, and the cloud as it is.
draw cumulus unchanged.png "${small[@]}"
for style in cartoon mcguire flat no-ink; do
    draw cumulus "style-$style.png" --style "$style" "${small[@]}"
done
for percent in 0 70 100; do
    form=$((percent / 100)).$((percent % 100))
    draw cumulus "form-$percent.png" --set "style.form=$form" "${small[@]}"
done
for percent in 25 100 400; do
    offset=$((percent / 100)).$((percent % 100))
    draw cumulus "ink-offset-$percent.png" --set "style.ink.offset=$offset" \
        --set style.ink.inner=1 --set style.ink.lit_thinning=0 "${small[@]}"
done
draw cumulus clean-0.png --set style.clean.px=0 "${small[@]}"
low_sun=(--set 'light[0].direction=[1, -0.35, -0.1]')
draw cumulus shadow-on.png "${low_sun[@]}" "${small[@]}"
draw cumulus shadow-off.png "${low_sun[@]}" --set style.shadow.on=false "${small[@]}"

# The chimney's smoke with vortices and without.
for solver in vortex forces; do
    draw chimney "solver-$solver.png" --frame 96 --set "object.smoke.solver=$solver" "${small[@]}"
done

draw cloud surface-thin.png --set object.cloud.shape.surface.threshold=0.05 "${small[@]}"
draw cloud surface-noise.png \
    --set 'object.cloud.shape.surface.noise={ amplitude = 1.6, size = 1, octaves = 1 }' "${small[@]}"

# Clouds after a paper's figures.
for cloud in cloud-detailed cloud-simple cloud-layers; do
    draw "$cloud" "$cloud.png" "${small[@]}"
done
draw cloud-layers layers-none.png --set 'object.cloud.shape.surface.detail=[]' "${small[@]}"

# A volume that another program made.
draw imported imported.png --frame 36 --size 480x540

# Volumes, one setting at a time.
puff=object.puff.shape.volume
for percent in 20 80; do
    draw puff-plain "volume-amplitude-$percent.png" --set "$puff.noise.amplitude=0.$((percent / 10))" --size 240x240
done
draw puff-plain volume-octaves-1.png --set "$puff.noise.octaves=1" --size 240x240
draw puff-plain volume-edge.png --set "$puff.edge=1" --size 240x240
for percent in 0 50 100; do
    soft=$((percent / 100)).$((percent % 100))
    draw puff-fuzzy "volume-soft-$percent.png" --set "$puff.soft=$soft" "${small[@]}"
done

# The plate of shadings, and each of them by itself: in its place of four columns and three rows.
draw shadings shadings.png --size 640x480 --set style.height=800
shadings=(gouraud solid two-tone three-tone steps ramp air focus velvet gooch exaggerated rim)
for i in "${!shadings[@]}"; do
    eye=$((-420 + 280 * (i % 4)))e-2
    height=$((677 - 280 * (i / 4)))
    draw shadings "shading-${shadings[i]}.png" --size 240x240 --set camera.fov=2.65 --set style.height=400 \
        --set "camera.eye=[$eye, $((height + 803))e-2, 60]" --set "camera.target=[$eye, ${height}e-2, 0]"
done

# The plate of hatching, and its other styles.
for style in engraving crosshatch pencil; do
    draw hatching "hatching-$style.png" --size 960x300 --style "$style"
done

for along in shade light curvature; do
    draw cloud "hatching-$along.png" --style engraving --set 'style.tones=["#f3ead6"]' \
        --set "style.hatching={ along = \"$along\", layers = 1 }" "${small[@]}"
done

for method in hybrid vector image shell angle; do
    draw cottage "line-$method.png" --frame 120 --size 320x240 --set style.height=440 \
        --set "style.ink.method=$method" --set camera.fov=24 --set 'camera.target=[1.7,2.9,0]'
done

# The kinds of edges, and hidden ones.
draw edges edges.png --size 480x360
draw edges edges-hidden.png --size 480x360 --set style.ink.hidden=dashed

# A drawing of shapes.
"$fumetto" export scenes/cumulus.toml -o "$images/vector.svg" --size 960x540

# The hand's tools, each along a cloud.
draw strokes strokes.png "${large[@]}"

# The editor, as its tests meet it.
FUMETTO_LOOK="$temporary" cargo test --locked --package fumetto-editor --test flows view
mv "$temporary/comic.png" "$images/editor.png"
mv "$temporary/dragged.png" "$images/editor-handles.png"
mv "$temporary/chimney.png" "$images/editor-smoke.png"

# The puffs' sprites: atlas.normal.png and its kin.
"$fumetto" export scenes/cumulus.toml -o "$images/atlas.png"
