"""Reads and writes the two chunks of a binary glTF file."""
import json
import struct


def read_glb(path):
    """Returns (JSON document, binary chunk)."""
    with open(path, "rb") as file:
        data = file.read()
    magic, version, _ = struct.unpack_from("<4sII", data)
    if magic != b"glTF" or version != 2:
        raise ValueError(f"{path}: not a glTF 2 binary file")
    size = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + size])
    return document, data[28 + size:]


def write_glb(path, document, binary):
    """Writes a binary glTF file, padding both chunks to four bytes."""
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)
