#!/usr/bin/env python3
"""Builds the page with emscripten and uses it in headless Chromium: every hash equals the native one, every switch works.

usage: page_test.py NATIVE_HASHES FOLDER [--jobs N] [--picture docs/pictures/page.png]
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from chromium import Page

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "host_sim/tools"))
import png  # noqa: E402
MOST_BYTES = 2 * 1024 * 1024
DOWN = ("ArrowDown", 40)
# A hash that changes with every picture of the glass, and with nothing else.
GLASS = """(() => { const c = document.getElementById("glass"); let h = 5381;
    for (const byte of c.getContext("2d").getImageData(0, 0, c.width, c.height).data) h = (h * 33 ^ byte) >>> 0; return h; })()"""
COLORS = """(() => { const c = document.getElementById("glass");
    return new Set(new Uint32Array(c.getContext("2d").getImageData(0, 0, c.width, c.height).data.buffer)).size; })()"""
failures = []


def check(holds, words):
    if not holds:
        failures.append(words)
        print(f"FAILED: {words}")


def text(page, selector):
    return page.ask(f"document.querySelector({selector!r}).textContent")


def well(page, where):
    check(page.ask("document.getElementById('problem').hidden"), f"{where}: {text(page, '#problem')}")
    check(text(page, "#violations") == "none", f"{where}: rules of the bus are broken: {text(page, '#violations')}")
    check(int(text(page, "#commands").replace(",", "")) > 0 or text(page, "#bytes") == "0", f"{where}: bytes without a command")


def compared(page, native):
    """Waits until the page has compared itself with the native hashes, and checks what the page says."""
    page.until("!document.getElementById('badge').classList.contains('pending')")
    page.until(f"document.querySelectorAll('#results tr').length === {native}")
    return text(page, "#badge"), page.ask("document.querySelectorAll('#results .different').length")


def walk(page, name, glass_differs):
    """Chooses every option of a select by the keyboard, as Chromium lets a person do it."""
    count = page.ask(f"document.getElementById('{name}').length")
    page.ask(f"(() => {{ const e = document.getElementById('{name}'); e.value = 0; e.dispatchEvent(new Event('change')); }})()")
    seen = {page.ask(GLASS)}
    for i in range(1, count):
        page.key(f"#{name}", *DOWN)
        page.until(f"document.getElementById('{name}').value === '{i}'", 5)
        well(page, f"{name} {i}")
        check(page.ask(COLORS) > 1 or name == "scene", f"{name} {i}: the glass shows one colour")
        seen.add(page.ask(GLASS))
    check(len(seen) >= glass_differs(count), f"{name}: {len(seen)} different pictures of {count} choices")


def switches(page):
    page.click("#pause")
    walk(page, "scene", lambda n: n - 2)  # S1 only clears, and a tiny scene may show what another scene does
    page.ask("(() => { const e = document.getElementById('scene'); e.value = 6; e.dispatchEvent(new Event('change')); })()")
    pictures, sizes = set(), set()
    for tier in (0, 1, 2):
        page.click(f"input[name=tier][value='{tier}']")
        check(page.ask(f"document.querySelector(\"input[name=tier][value='{tier}']\").checked"), f"tier {tier} is not chosen")
        well(page, f"tier {tier}")
        pictures.add(page.ask(GLASS))
    check(len(pictures) >= 2, "tiers: the pictures are the same")
    page.click("input[name=tier][value='0']")
    walk(page, "format", lambda n: 2)
    walk(page, "board", lambda n: n // 2)
    page.ask("(() => { const e = document.getElementById('board'); e.value = 0; e.dispatchEvent(new Event('change')); })()")
    # The viewer can walk around a scene that stands still, and comes back to the first view.
    front = page.ask(GLASS)
    page.drag("#glass", 90, 30)
    aside = page.ask(GLASS)
    check(aside != front, "dragging changes nothing")
    page.key("#glass", "ArrowLeft", 37)
    check(page.ask(GLASS) not in (front, aside), "the arrow keys change nothing")
    page.click("#front")
    check(page.ask(GLASS) == front, "the view from the front is another picture than before")
    page.click("#step")
    check(page.ask(GLASS) != front, "one frame on is the same picture")
    page.click("#pause")
    check(page.ask("location.hash").startswith("#scene=S5&board=ili9341-spi&tier=exact"), f"the link is {page.ask('location.hash')}")


def accessible(page):
    for node in page.call("Accessibility.getFullAXTree")["nodes"]:
        properties = {p["name"]: p["value"].get("value") for p in node.get("properties", [])}
        if properties.get("focusable") and node["role"]["value"] not in ("RootWebArea", "MenuListPopup", "option"):
            check(node.get("name", {}).get("value"), f"no name for what the keyboard reaches: {node['role']['value']}")


def fits(page, where):
    wide, room = page.ask("[document.documentElement.scrollWidth, innerWidth]")
    check(wide <= room, f"{where}: the page is {wide} pixels wide, the window {room}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("hashes")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jobs", default="2")
    parser.add_argument("--picture", type=pathlib.Path)
    words = parser.parse_args()
    browser = shutil.which("chromium")
    if browser is None or shutil.which("emcmake") is None:
        print("skipped: needs Debian's emscripten and chromium")
        return 77
    subprocess.run([sys.executable, ROOT / "host_sim/page/make.py", words.hashes, words.folder, "--jobs", words.jobs], check=True)
    file = words.folder.resolve() / "index.html"
    check(file.stat().st_size <= MOST_BYTES, f"the page has {file.stat().st_size} bytes")
    html = file.read_text()
    check(not re.search(r"""(src|href)=["'](?!data:)""", html), "the page names another file")
    native = len(re.findall(r"^\[\d", html, re.M))
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)
        with Page(browser, place / "desk", 1280, 800) as page:
            page.open(file.as_uri())
            badge, different = compared(page, native)
            print(badge)
            check(badge == f"\u2713 same hash as native: {native} of {native}" and different == 0, f"the badge says: {badge}")
            page.until("/per second/.test(document.getElementById('rate').textContent)")
            page.ask("new Promise((resolve) => { setTimeout(resolve, 1500); })")
            print("frame rate, ms of drawing, bus and controller, scan-out:", *(text(page, f"#{i}") for i in ("rate", "draw", "present", "scan")))
            well(page, "the beginning")
            fits(page, "1280x800")
            accessible(page)
            page.screenshot(words.folder / "desk.png")
            if words.picture:
                words.picture.write_bytes(png.write(png.read((words.folder / "desk.png").read_bytes())[2]))
            switches(page)
            check(not page.complaints, f"the console: {page.complaints}")
        # The page must notice one wrong digit of a native hash.
        wrong = place / "wrong.html"
        wrong.write_text(re.sub(r'(\[0, 4, 1, 0, ")(.)', lambda m: m[1] + ("1" if m[2] == "0" else "0"), html, count=1))
        with Page(browser, place / "phone", 390, 844, phone=True) as page:
            page.open(wrong.as_uri() + "#scene=CUBE&board=ssd1306-i2c&tier=fast")
            badge, different = compared(page, native)
            check(badge == f"not the same as native: 1 of {native}" and different == 1, f"a wrong hash, and the badge says: {badge}")
            check(page.ask("document.querySelector('#scene').selectedOptions[0].text").startswith("CUBE"), "a link does not choose the scene")
            check(page.ask("document.getElementById('glass').width") == 128, "a link does not choose the board")
            fits(page, "390x844")
            page.screenshot(words.folder / "phone.png")
            check(not page.complaints, f"the console of the phone: {page.complaints}")
    print("failures:", len(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
