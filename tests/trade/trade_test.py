#!/usr/bin/env python3
"""`spangle trade`: figures of all scenes, the bytes they draw, shards, formats, the page, and what is refused.

usage: trade_test.py SPANGLE golden|models|bytes|shards|page|errors

golden: accuracy.csv of all scenes is tests/trade/golden.csv, and the promises that are broken are those of tests/trade/missed.txt,
no more and no fewer. models: the same of models, golden_models.csv and missed_models.txt. bytes: what each scene draws in each tier
and format has the hash of tests/trade/bytes.txt; so any byte that changes is seen. SPANGLE_UPDATE_GOLDEN=1 writes all these anew.
shards: parts that are merged are the bytes of one sweep.
page: the page in a headless Chromium: sliders move, nothing complains. Skipped where there is none.
"""
import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SPANGLE = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else None
MODELS = pathlib.Path("/usr/share/assimp/models")
FORMATS = "565,888,8888,666,444,332,grey4,mono"
FOR_THE_PAGE = ["S4r", "S7", "CUBE", "--formats", "565,grey4", "--frames", "2", "--size", "96x64"]


def check(good, what):
    if not good:
        sys.exit(f"trade: {what}")


def trade(folder, *words, status=0):
    done = subprocess.run([SPANGLE, "trade", *words], cwd=folder, capture_output=True, text=True)
    check(done.returncode == status, f"{' '.join(words)} ends with {done.returncode}: {done.stdout[-500:]}{done.stderr}")
    return done


def held(folder, name, *words):
    """Figures and broken promises of what `words` name are those of the golden files; gives the broken promises."""
    said = trade(folder, *words, "--no-times", "--frames", "2", "--out", "all").stdout
    figures = (folder / "all/accuracy.csv").read_text()
    missed = "".join(line + "\n" for line in said.splitlines() if re.match(r"\S+ in \w+, \w+: ", line))
    golden_file, missed_file = HERE / f"golden{name}.csv", HERE / f"missed{name}.txt"
    if os.environ.get("SPANGLE_UPDATE_GOLDEN") == "1":
        golden_file.write_text(figures)
        missed_file.write_text(missed)
    want = golden_file.read_text()
    if figures != want:
        for new, old in zip(csv.DictReader(figures.splitlines()), csv.DictReader(want.splitlines())):
            for column, cell in new.items():
                if cell != old.get(column):
                    print(f"{new['scene']}, {new['tier']}: {column} is {cell}, was {old.get(column)}")
        sys.exit(f"trade: figures are others than in {golden_file.name}; if that is meant, SPANGLE_UPDATE_GOLDEN=1 writes it anew")
    check(missed == missed_file.read_text(), f"other promises are broken than those of {missed_file.name}:\n{missed}")
    for row in csv.DictReader(figures.splitlines()):
        check(row["off_own"] == "0", f"{row['scene']}, {row['tier']}: coverage is off brute force")
        check(row["off_unsnapped"] == row["off_ideal"], f"{row['scene']}, {row['tier']}: more than n.8 costs is off")
    return missed


def same_hashes(folder, file, *words):
    """What `--bytes` prints of these words is the golden file: a line for each program, format and tier."""
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


def golden(folder):
    missed = held(folder, "")
    trade(folder, "S6", "--no-times", "--frames", "2", "--strict", "--out", "strict", status=1 if "S6 in" in missed else 0)
    trade(folder, "S3", "--no-times", "--frames", "1", "--strict", "--out", "strict")


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
document.title = 'heard ' + heard.join('|');
</script></body>"""


def page(folder):
    browser = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if browser is None:
        print("skipped: there is no Chromium")
        sys.exit(77)
    trade(folder, *FOR_THE_PAGE, "--out", "all")
    html = (folder / "all/index.html").read_text()
    check(not re.search(r"(src|href)=\"(?!data:)", html), "the page needs another file")
    (folder / "slid.html").write_text(html.replace("</body>", SLIDE))
    words = [browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder / 'profile'}", "--enable-logging=stderr"]

    def browse(*more):
        done = subprocess.run([*words, *more], capture_output=True, text=True, timeout=120)
        check("CONSOLE" not in done.stderr, f"the page complains: {[line for line in done.stderr.splitlines() if 'CONSOLE' in line]}")
        return done.stdout

    drawn = browse("--dump-dom", (folder / "slid.html").as_uri())
    heard = re.search(r"<title>heard (.*?)</title>", drawn)
    check(heard is not None, "the page's script did not run")
    steps = [f"{tier}+where {tier} differs from double" for tier in ("exact", "balanced", "fast")]
    check(heard.group(1).split("|") == steps * 6, f"sliders show {heard.group(1)}")
    if shutil.which("gnuplot"):
        check(html.count("<svg") == 2 and html.count("No plot") == 0, "the plots are missing")
    shot = folder / "shot.png"
    browse("--window-size=1100,1600", f"--screenshot={shot}", (folder / "all/index.html").as_uri())
    check(shot.stat().st_size > 20000, "the picture of the page is empty")


def errors(folder):
    for words, says in ((["S99"], "no scene 'S99'"), (["--size", "0x4"], "--size takes"), (["--shard", "3/2"], "--shard takes I/N"),
                        (["--tiers", "best"], "--tiers"), (["--formats", "909"], "--formats"), (["--model", "none.obj"], "none.obj"),
                        (["merge", "nowhere", "--out", "x"], "cannot read 'nowhere/accuracy.csv'"), (["S1", "--out", "file/x"], "cannot make folder")):
        (folder / "file").write_text("")
        said = trade(folder, *words, status=2).stderr
        check(says in said, f"{' '.join(words)} says {said}")
    (folder / "bad/pictures").mkdir(parents=True)
    (folder / "bad/accuracy.csv").write_text("job,jobs\n1\n")
    said = trade(folder, "merge", "bad", "--out", "x", status=2).stderr
    check("row 1 has 1 cells for 2 columns" in said, f"a broken table is not named: {said}")


def main():
    parts = {"golden": golden, "models": models, "bytes": bytes_drawn, "shards": shards, "page": page, "errors": errors}
    if len(sys.argv) != 3 or sys.argv[2] not in parts:
        sys.exit(__doc__.strip())
    with tempfile.TemporaryDirectory() as folder:
        parts[sys.argv[2]](pathlib.Path(folder))


if __name__ == "__main__":
    main()
