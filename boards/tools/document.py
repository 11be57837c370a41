"""Writes what was measured and seen into docs/boards.md: the table, the footnotes, and a picture of each screen."""
import firmware
from firmware import outfile

PAGE = firmware.ROOT / "docs/boards.md"
PICTURES = firmware.ROOT / "docs/pictures/boards"
BEGIN, END = "<!-- measured: ./dev boards --document -->\n", "<!-- end -->\n"


def markdown(header, rows, notes):
    lines = ["| " + " | ".join(header) + " |", "|---" * len(header) + "|", *("| " + " | ".join(row) + " |" for row in rows)]
    return "\n".join(lines) + "\n" + "".join(f"\n* {note}" for note in notes) + "\n"


def keep_pictures(boards, drawn):
    """Copies pictures to the documents, equal pictures once. Returns the rows of the page's table of pictures."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    for old in PICTURES.glob("*.png"):
        old.unlink()
    known, groups = {}, {}
    for board in boards:
        if not board.trace and not board.screen:
            continue  # nothing sees this board's display, so only hashes are compared
        files = []
        for scene in board.scenes:
            source = drawn / f"{board.name}-{scene}.png"
            content = source.read_bytes()
            if content not in known:
                known[content] = source.name
                outfile.write(PICTURES / source.name, source.read_bytes())
            files.append(known[content])
        groups.setdefault(tuple(files), []).append(board.name)
    return [(", ".join(names), " ".join(f"![{names[0]}](pictures/boards/{file})" for file in files)) for files, names in groups.items()]


def write(header, rows, notes, pictures):
    before, _, rest = PAGE.read_text().partition(BEGIN)
    _, _, after = rest.partition(END)
    shown = "".join(f"\n{names}:\n\n{images}\n" for names, images in pictures)
    outfile.write(PAGE, before + BEGIN + "\n" + markdown(header, rows, notes) + "\n## What they show\n" + shown + "\n" + END + after)
