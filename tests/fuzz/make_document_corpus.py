#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what job_document_fuzz starts from into FOLDER: `corpus/`, every readable row of malformed_documents.json, its
well-formed document and the small scenes of client-examples, and `words`, a dictionary of all keys and words.

    tests/fuzz/make_document_corpus.py FOLDER
"""
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "api"))
import check_schemas  # noqa: E402: found by the line above


def words_of(node):
    """Every key and string of a document."""
    if isinstance(node, dict):
        for key, value in node.items():
            yield key
            yield from words_of(value)
    elif isinstance(node, list):
        for value in node:
            yield from words_of(value)
    elif isinstance(node, str):
        yield node


def main():
    folder = pathlib.Path(sys.argv[1])
    corpus = folder / "corpus"
    corpus.mkdir(parents=True, exist_ok=True)
    table = json.loads((ROOT / "tests" / "api" / "malformed_documents.json").read_text())
    documents = [table["base"]] + [check_schemas.parsed(table["base"], row) for row in table["documents"]]
    for scene in sorted((ROOT / "client-examples" / "scenes").rglob("*.json")):
        if scene.stat().st_size < 20_000:
            documents.append(json.loads(scene.read_text()))
    words = set()
    for number, document in enumerate(d for d in documents if d is not None):
        (corpus / f"{number:03}.json").write_text(json.dumps(document, separators=(",", ":")))
        words.update(word for word in words_of(document) if word.isascii() and word.isprintable() and len(word) < 40)
    lines = [json.dumps(json.dumps(word)) for word in sorted(words)]
    (folder / "words").write_text("".join(f"{line}\n" for line in lines))


if __name__ == "__main__":
    main()
