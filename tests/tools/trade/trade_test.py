#!/usr/bin/env python3
"""Tests `spangle trade`: figures of all scenes, the bytes they draw, shards, formats, the page, and what is refused.

usage: trade_test.py SPANGLE golden|models|bytes|shards|tiers|page|errors|firmware|picture [few|I/N|TARGET]

golden: accuracy.csv of all scenes must be tests/tools/trade/golden.csv, and the broken promises must be exactly those of
tests/tools/trade/missed.txt. `few` takes one scene for each kind of promise, I/N takes every Nth program from the Ith on.
models: the same for models, with golden_models.csv and missed_models.txt. bytes: each scene in each tier and format must draw bytes with
the hash in tests/tools/trade/bytes.txt, so any changed byte is seen. SPANGLE_UPDATE_GOLDEN=1 writes all these files anew; with tiers it
writes the table of knobs in docs/trade.md.
shards: merged parts have the bytes of one sweep. tiers: composed tiers, and instructions of boards, whose emulator is a script here.
firmware: the same with real images of TARGET in QEMU; skipped without compiler or emulator. page: the page in a headless Chromium: sliders
move, and nothing complains; skipped without Chromium. picture: no test; draws docs/pictures/trade.png.
"""
import csv
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "host_sim/tools"))
import outfile  # noqa: E402
import png  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
SPANGLE = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else None
MODELS = pathlib.Path("/usr/share/assimp/models")
FORMATS = "565,888,8888,666,444,332,grey4,mono"
DOCUMENT = HERE.parents[2] / "docs/trade.md"
FEW = ["S4r", "S7", "S9", "FOG", "OFFSET"]  # texels, blending, light and fog, a plane to the horizon, coverage
PICTURED = ["S4", "S4b", "S4r", "S6", "S7", "S9", "HUD", "BAKED", "FOG"]
PICTURE = HERE.parents[2] / "docs/pictures/trade.png"
FOR_THE_PAGE = ["S4r", "S7", "CUBE", "--formats", "565,grey4", "--frames", "2", "--size", "96x64"]


def check(good, what):
    if not good:
        sys.exit(f"trade: {what}")


def trade(folder, *words, status=0):
    done = subprocess.run([SPANGLE, "trade", *words], cwd=folder, capture_output=True, text=True)
    check(done.returncode == status, f"{' '.join(words)} ends with {done.returncode}: {done.stdout[-500:]}{done.stderr}")
    return done


def by_program(figures):
    """Returns the rows of accuracy.csv by program and tier. A part of a sweep numbers its jobs by itself."""
    return {(row["scene"], row["tier"]): {**row, "job": "", "jobs": ""} for row in csv.DictReader(figures.splitlines())}


def held(folder, name, *words, whole=True):
    """Checks that the figures and broken promises for `words` are those of the golden files; unless `whole`, they are a part of these."""
    said = trade(folder, *words, "--no-times", "--frames", "2", "--out", "all").stdout
    figures = (folder / "all/accuracy.csv").read_text()
    missed = "".join(line + "\n" for line in said.splitlines() if re.match(r"\S+ in \w+, \w+: ", line))
    golden_file, missed_file = HERE / f"golden{name}.csv", HERE / f"missed{name}.txt"
    if os.environ.get("SPANGLE_UPDATE_GOLDEN") == "1" and whole:
        golden_file.write_text(figures)
        missed_file.write_text(missed)
    want, found = by_program(golden_file.read_text()), by_program(figures)
    programs = {scene for scene, _ in found}
    if not whole:
        want = {key: row for key, row in want.items() if key[0] in programs}
    changed = [f"{key[0]}, {key[1]}: {column} is {cell}, was {want.get(key, {}).get(column)}"
               for key, row in found.items() for column, cell in row.items() if cell != want.get(key, {}).get(column)]
    check(not changed, "\n".join(changed) + f"\nfigures are others than in {golden_file.name}; if that is meant, SPANGLE_UPDATE_GOLDEN=1 writes it anew")
    check(found and found.keys() == want.keys(), f"other programs than in {golden_file.name}: {sorted(found.keys() ^ want.keys())}")
    broken = "".join(line + "\n" for line in missed_file.read_text().splitlines() if whole or line.split(" in ")[0] in programs)
    check(missed == broken, f"other promises are broken than those of {missed_file.name}:\n{missed}")
    for (scene, tier), row in found.items():
        check(row["off_own"] == "0", f"{scene}, {tier}: coverage is off brute force")
        check(row["off_unsnapped"] == row["off_ideal"], f"{scene}, {tier}: more than n.8 costs is off")
    return missed


def same_hashes(folder, file, *words):
    """Checks that `--bytes` prints the golden file for these words: a line for each program, format and tier."""
    said = trade(folder, "--bytes", *words).stdout
    if os.environ.get("SPANGLE_UPDATE_GOLDEN") == "1":
        file.write_text(said)
    want, found = ({line.rpartition(" ")[0]: line.rpartition(" ")[2] for line in text.splitlines()} for text in (file.read_text(), said))
    for job in sorted(want.keys() | found.keys()):
        check(want.get(job) == found.get(job), f"{job} draws other bytes: {found.get(job)}, in {file.name} {want.get(job)}; "
              "if that is meant, SPANGLE_UPDATE_GOLDEN=1 writes the file anew")
    check(said.splitlines() == sorted(said.splitlines()) and len(found) == len(said.splitlines()), "lines are not sorted, or twice there")
    return found


def bytes_drawn(folder):
    found = same_hashes(folder, HERE / "bytes.txt", "--formats", FORMATS, "--size", "160x120", "--frames", "2")
    programs = {job.split()[0] for job in found}
    check(len(found) == len(programs) * 8 * 3 and {"SHADOW", "S9", "WRAPS"} <= programs, f"not all jobs are there: {len(found)}")
    half = [trade(folder, "--bytes", "S4r", "S5", "--size", "80x60", "--frames", "1", "--shard", part).stdout for part in ("1/2", "2/2")]
    whole = trade(folder, "--bytes", "S4r", "S5", "--size", "80x60", "--frames", "1").stdout
    check("".join(half) == whole and half[0], "shards print other bytes")
    check(len({line.split()[-1] for line in whole.splitlines()}) > 3, "tiers and scenes draw the same bytes")


def models(folder):
    files = [MODELS / name for name in ("Collada/duck.dae", "OBJ/spider.obj", "STL/Spider_ascii.stl")]
    held(folder, "_models", *(word for file in files for word in ("--model", str(file))))


def golden(folder, part=""):
    if "/" in part:
        held(folder, "", "--shard", part, whole=False)
        return
    missed = held(folder, "", *(FEW if part else []), whole=not part)
    trade(folder, "GROUND", "--no-times", "--frames", "1", "--size", "96x64", "--strict", "--out", "strict", status=1)
    trade(folder, "S3", "--no-times", "--frames", "1", "--size", "96x64", "--strict", "--out", "strict")
    check("S4r in" in missed and "S7 in" not in missed, f"promises are broken by other scenes: {missed}")


def shards(folder):
    trade(folder, *FOR_THE_PAGE, "--no-times", "--out", "whole")
    for part in ("3/3", "1/3", "2/3"):
        trade(folder, *FOR_THE_PAGE, "--no-times", "--shard", part, "--out", f"part{part[0]}")
        check(not (folder / f"part{part[0]}/index.html").exists(), "a shard has a page")
    refused = trade(folder, "merge", "part1", "part2", "--out", "merged", status=2)
    check("no part has job 2 of 6" in refused.stderr, f"a missing part is not named: {refused.stderr}")
    trade(folder, "merge", "part2", "part3", "part1", "--out", "merged")
    whole = sorted(path.relative_to(folder / "whole") for path in (folder / "whole").rglob("*") if path.is_file())
    merged = sorted(path.relative_to(folder / "merged") for path in (folder / "merged").rglob("*") if path.is_file())
    check(whole == merged and len(whole) == 3 + 6 * 7, f"other files: {whole} {merged}")
    for name in whole:
        check((folder / "whole" / name).read_bytes() == (folder / "merged" / name).read_bytes(), f"{name} has other bytes")
    rows = list(csv.DictReader((folder / "merged/accuracy.csv").open()))
    check(len(rows) == 18, "there are not three tiers of three scenes in two formats")
    sizes = {row["format"]: int(row["frame_bytes"]) for row in rows}
    check(sizes == {"565": 96 * 64 * 2, "grey4": 96 * 64 // 2}, f"frames have other bytes: {sizes}")
    check(all(row["coord_0_worst"] != "" for row in rows if row["scene"] == "S4r"), "a texture has no texel error")
    check(all(float(row["perceived"]) > 0.2 for row in rows if row["format"] == "grey4" and row["scene"] == "S4r"), "grey looks like colours")
    trade(folder, "S5", "--frames", "2", "--tiers", "fast,exact", "--out", "timed")
    costs = list(csv.DictReader((folder / "timed/cost.csv").open()))
    check([row["tier"] for row in costs] == ["exact", "fast"], "tiers are not in their own order")
    check(all(float(row["microseconds"]) > 0 for row in costs) and costs[0]["relative"] == "1.000", f"no times: {costs}")
    accuracy = list(csv.DictReader((folder / "timed/accuracy.csv").open()))
    check(all(0 < int(row["bus_bytes"]) <= 320 * 240 * 2 + 64 for row in accuracy), "gears send no bytes, or more than a frame")


def tiers(folder):
    said = trade(folder, "--knobs").stdout
    check(all(re.search(rf"^{knob} .*\S", said, re.M) for knob in ("color_bits", "texel_bits", "affine_fog_bits")), f"knobs are not listed: {said}")
    rows = ["| " + " | ".join(re.split(r"  +", line.strip())) + " |\n" for line in said.splitlines()[1:]]
    before, rest = DOCUMENT.read_text().split("<!-- knobs -->\n")
    document = before + "<!-- knobs -->\n" + "".join(rows) + "<!-- end -->" + rest.split("<!-- end -->", 1)[1]
    if os.environ.get("SPANGLE_UPDATE_GOLDEN") == "1":
        DOCUMENT.write_text(document)
    check(document == DOCUMENT.read_text(), "docs/trade.md lists other knobs; SPANGLE_UPDATE_GOLDEN=1 writes its table anew")
    own = ["--tier", "coarse=balanced,texel_bits=0,affine_texel_bits=never", "--tier", "same=fast"]
    trade(folder, "S4r", "S9", "--no-times", "--frames", "2", "--size", "96x64", *own, "--out", "own")
    rows = {(row["scene"], row["tier"]): row for row in csv.DictReader((folder / "own/accuracy.csv").open())}
    check([tier for scene, tier in rows if scene == "S9"] == ["exact", "balanced", "fast", "coarse", "same"], f"tiers are not rows in their order: {list(rows)}")
    for scene in ("S4r", "S9"):
        fast, same = rows[scene, "fast"], rows[scene, "same"]
        check({**fast, "tier": ""} == {**same, "tier": ""}, f"{scene}: the knobs of fast are not fast")
    texels = {tier: float(rows["S4r", tier]["texel_rms"]) for tier in ("balanced", "coarse")}
    check(texels["coarse"] > 1.5 * texels["balanced"], f"a knob changes nothing: {texels}")
    html = (folder / "own/index.html").read_text()
    check("<td>coarse<td>" in html and "Coarse: " in html, "the page lacks an own tier")
    shot = ["S4r", "--size", "96x64", "--dither", "off", "--json"]
    hashes = [subprocess.run([SPANGLE, "run", *shot, *words], capture_output=True, text=True).stdout for words in (["--precision", "fast"], ["--knobs", "fast"], ["--knobs", "fast,color_bits=20,runs=cubic"])]
    check(hashes[0] == hashes[1] != hashes[2] and hashes[2], f"spangle run takes no knobs: {hashes}")
    refused = subprocess.run([SPANGLE, "run", "S1", "--knobs", "fast,x=1"], capture_output=True, text=True)
    check(refused.returncode == 2 and "spangle trade --knobs" in refused.stderr, f"an unknown knob is not named: {refused.stderr}")
    builder = HERE.parent / "bench/trade_firmware.py"
    for words, says in ((["S99"], "no scene S99"), (["S1", "--targets", "m5"], "no m5"), (["S1", "--tier", "x=fast,speed=1"], "--knobs"), (["S1", "--tier", "fast=exact"], "already"),
                        (["--model", "none.obj"], "none.obj"), (["S1", "--used-spans", "--spangle", "nowhere"], "`./dev build` makes it")):
        done = subprocess.run([sys.executable, builder, "--spangle", SPANGLE, "--out", folder / "images", *words], cwd=folder, capture_output=True, text=True)
        check(done.returncode in (2, 77) and (done.returncode == 77 or says in done.stderr), f"./dev firmware {words} says {done.returncode}: {done.stderr}")
    emulated(folder)


def emulated(folder):
    """Tests boards with an emulator that prints the same for every image; the images are not Spangle's."""
    fake = folder / "bin"
    (folder / "firmware/m4").mkdir(parents=True)
    fake.mkdir()
    emulator = fake / "qemu-system-arm"
    for hash, complaint in (("0", "draws another picture"), (None, "is no ELF image")):
        emulator.write_text(f"#!/bin/sh\nprintf 'frame 9 {hash or 0}\\nown 0\\nsurface 0\\npeak 1\\nstack 1\\n'\n")
        emulator.chmod(0o755)
        image = struct.pack("<16sHHIIIIIHHHHHH", b"\x7fELF\x01\x01\x01", 2, 40, 1, 0, 0, 52, 0, 52, 0, 0, 40, 1, 0) + bytes(40)
        (folder / "firmware/m4/S2-exact.elf").write_bytes(image if hash else b"text")
        words = ["S2", "--no-times", "--frames", "1", "--size", "96x64", "--tiers", "exact", "--targets", "m4", "--firmware", "firmware", "--out", "counted"]
        done = subprocess.run([SPANGLE, "trade", *words], cwd=folder, capture_output=True, text=True, env={**os.environ, "PATH": f"{fake}:{os.environ['PATH']}"})
        check(done.returncode == 0 and f"m4 is not counted" in done.stderr and complaint in done.stderr, f"a wrong image is counted: {done.stderr}")
    said = trade(folder, "S5", "--no-times", "--frames", "1", "--size", "96x64", "--tiers", "exact", "--targets", "m4", "--firmware", "firmware", "--out", "counted").stderr
    check("there is no firmware/m4/S5-exact.elf" in said and "./dev firmware" in said, f"a missing image is not named: {said}")
    row = next(csv.DictReader((folder / "counted/cost.csv").open()))
    check(float(row["triangles"]) > 100 and float(row["fragments"]) > 500 and row["m4_instructions"] == "", f"S5 draws nothing: {row}")


def firmware(folder, target):
    builder = HERE.parent / "bench/trade_firmware.py"
    own, model = ["--tier", "fine=balanced,texel_bits=4,affine_texel_bits=4"], ["--model", str(HERE.parents[2] / "boards/scenes/models/rocket.obj")]
    built = subprocess.run([sys.executable, builder, "S4r", *model, "--targets", target, "--tiers", "balanced,fast", *own, "--used-spans", "--spangle", SPANGLE, "--out", folder / "firmware"], capture_output=True, text=True)
    if built.returncode == 77:
        print(built.stdout)
        sys.exit(77)
    check(built.returncode == 0, f"the firmware does not build: {built.stdout}{built.stderr}")
    said = trade(folder, "S4r", *model, "--no-times", "--frames", "1", "--tiers", "balanced,fast", *own, "--targets", target, "--firmware", "firmware", "--out", "counted")
    check("not counted" not in said.stderr, said.stderr)
    every = list(csv.DictReader((folder / "counted/cost.csv").open()))
    rows = {row["tier"]: row for row in every if row["scene"] == "S4r"}
    check(len(every) == 6 and list(rows) == ["balanced", "fast", "fine"], f"other programs and tiers were counted: {every}")
    check(all(row[f"{target}_instructions"] for row in every), f"a model or a tier is not counted: {every}")
    check(int(rows["fine"][f"{target}_instructions"]) > int(rows["balanced"][f"{target}_instructions"]), f"more texel bits take nothing: {rows}")
    balanced, fast = rows["balanced"], rows["fast"]
    check(int(fast[f"{target}_instructions"]) < int(balanced[f"{target}_instructions"]) < 30_000_000, f"fast is not quicker: {rows}")
    pixel = int(fast[f"{target}_instructions"]) / float(fast["fragments"])
    check(abs(float(fast[f"{target}_per_pixel"]) - pixel) < 0.06, f"{pixel} instructions a pixel are not told")
    for row in rows.values():
        check(30_000 < int(row[f"{target}_flash"]) < 800_000 and 4_000 < int(row[f"{target}_ram"]) < 200_000, f"what is that memory? {row}")
    check(f"fewer instructions on {target}" in said.stdout, f"boards are not advised on: {said.stdout}")


SLIDE = """<script>
const heard = [];
for (const scene of document.querySelectorAll('.scene')) {
  const slider = scene.querySelector('input');
  for (const value of ['0', '1', '2']) {
    slider.value = value;
    slider.dispatchEvent(new Event('input'));
    const shown = [...scene.querySelectorAll('[data-tier]')].filter(part => !part.hidden);
    heard.push(shown.map(part => part.querySelector('figcaption').textContent).join('+'));
    for (const image of scene.querySelectorAll('img'))
      if (!image.complete || image.naturalWidth !== 96) heard.push('broken picture ' + image.alt);
  }
}
const list = document.getElementById('axis'), plots = [...document.querySelectorAll('[data-axis]')];
const shown = [];
for (const option of list ? list.options : []) {
  list.value = option.value;
  list.dispatchEvent(new Event('change'));
  shown.push(option.textContent + ':' + plots.map(plot => +!plot.hidden).join(''));
}
heard.push('axes ' + shown.join(';'));
document.title = 'heard ' + heard.join('|');
</script></body>"""


def count_by_hand(path):
    """Writes instructions on a board into the file, as if they had been counted."""
    rows = list(csv.DictReader(path.open()))
    for i, row in enumerate(rows):
        row["m4_instructions"], row["m4_per_pixel"] = 3000 - 1000 * (i % 3), "9.5"
    with path.open("w", newline="") as file:
        table = csv.DictWriter(file, rows[0], lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def chromium(folder):
    """Returns the command with which every look at a page begins."""
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if browser is None:
        print("skipped: there is no Chromium")
        sys.exit(77)
    return [browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder / 'profile'}", "--enable-logging=stderr"]


def picture(folder):
    """Draws docs/pictures/trade.png: the page of a few programs without its figures, and the pictures of one of them."""
    browser, width, shown = chromium(folder), 900, 2
    trade(folder, *PICTURED, "--out", "all")
    style = "h1~h2:nth-of-type(n+2),.wide,.wide~p,.scene{display:none}" f"#job{shown}{{display:block}}body{{margin:1em auto}}img{{width:272px}}"
    (folder / "some.html").write_text((folder / "all/index.html").read_text().replace("</style>", style + "</style>"))
    shot = folder / "shot.png"
    subprocess.run([*browser, f"--window-size={width},1800", "--hide-scrollbars", f"--screenshot={shot}", (folder / "some.html").as_uri()],
                   capture_output=True, timeout=120, check=True)
    rows = png.read(shot.read_bytes())[2]
    while set(rows[-1]) == {(255, 255, 255)}:
        rows.pop()
    outfile.write(PICTURE, png.write(rows + [rows[0]] * 12))


def page(folder):
    words = chromium(folder)
    trade(folder, *FOR_THE_PAGE, "--out", "timed")
    count_by_hand(folder / "timed/cost.csv")
    trade(folder, "merge", "timed", "--out", "all")
    html = (folder / "all/index.html").read_text()
    check(not re.search(r"(src|href)=\"(?!data:)", html), "the page needs another file")
    (folder / "slid.html").write_text(html.replace("</body>", SLIDE))

    def browse(*more):
        done = subprocess.run([*words, *more], capture_output=True, text=True, timeout=120)
        check("CONSOLE" not in done.stderr, f"the page complains: {[line for line in done.stderr.splitlines() if 'CONSOLE' in line]}")
        return done.stdout

    drawn = browse("--dump-dom", (folder / "slid.html").as_uri())
    heard = re.search(r"<title>heard (.*?)</title>", drawn)
    check(heard is not None, "the page's script did not run")
    steps = [f"{tier}+where {tier} differs from double" for tier in ("exact", "balanced", "fast")]
    *slid, axes = heard.group(1).split("|")
    check(slid == steps * 6, f"sliders show {slid}")
    check("<th>m4 per pixel" in html and "<th>m4 flash" not in html and "fewer instructions on m4" in html, "the page does not show what was counted")
    if shutil.which("gnuplot"):
        check(html.count("<svg") == 3 and html.count("No plot") == 0, "the plots are missing")
        check(axes == "axes instructions on m4:10;time:01", f"the list of axes shows {axes}")
    shot = folder / "shot.png"
    browse("--window-size=1100,1600", f"--screenshot={shot}", (folder / "all/index.html").as_uri())
    check(shot.stat().st_size > 20000, "the picture of the page is empty")


def errors(folder):
    for words, says in ((["S99"], "no scene 'S99'"), (["--size", "0x4"], "--size takes"), (["--shard", "3/2"], "--shard takes I/N"),
                        (["--tiers", "best"], "--tiers"), (["--formats", "909"], "--formats"), (["--targets", "m5"], "--targets"),
                        (["--tier", "mine"], "--tier takes NAME=BASE"), (["--tier", "a=fast,texel_bits=99"], "texel_bits takes 0 to 13"),
                        (["--tier", "a=fast", "--tier", "a=exact"], "already"), (["--targets", "m4"], "`./dev firmware --out DIR` builds images"),
                        (["--targets", "m4", "--firmware", "nowhere"], "has no images for m4"), (["S1", "--firmware", "nowhere"], "is for --targets"), (["--model", "none.obj"], "none.obj"),
                        (["merge", "nowhere", "--out", "x"], "cannot read 'nowhere/accuracy.csv'"), (["S1", "--out", "file/x"], "cannot make folder")):
        (folder / "file").write_text("")
        said = trade(folder, *words, status=2).stderr
        check(says in said, f"{' '.join(words)} says {said}")
    (folder / "bad/pictures").mkdir(parents=True)
    (folder / "bad/accuracy.csv").write_text("job,jobs\n1\n")
    said = trade(folder, "merge", "bad", "--out", "x", status=2).stderr
    check("row 1 has 1 cells for 2 columns" in said, f"a broken table is not named: {said}")


def main():
    parts = {"golden": golden, "models": models, "bytes": bytes_drawn, "shards": shards, "tiers": tiers, "page": page,
             "errors": errors, "firmware": firmware, "picture": picture}
    words = {"golden": r"|few|\d+/\d+", "firmware": "m0plus|m3|m4|rv32"}
    part = "".join(sys.argv[2:3])
    if part not in parts or len(sys.argv) > 4 or not re.fullmatch(words.get(part, ""), "".join(sys.argv[3:])):
        sys.exit(__doc__.strip())
    with tempfile.TemporaryDirectory() as folder:
        parts[part](pathlib.Path(folder), *sys.argv[3:])


if __name__ == "__main__":
    main()
