"""Tables within a document, between two marks."""


def put_between(path, begin, end, text):
    page = path.read_text()
    if begin not in page or end not in page:
        raise SystemExit(f"{path}: the lines '{begin}' and '{end}' are missing; the table goes between them")
    path.write_text(page[:page.index(begin)] + begin + "\n" + text + page[page.index(end):])
