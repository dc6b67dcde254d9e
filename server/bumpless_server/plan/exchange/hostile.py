"""XML and archives from strangers: no entities, no bombs, nothing that takes longer than reading it once."""

import io
import zipfile
from xml.etree.ElementTree import Element, ParseError

from bumpless.contract.extras import imported
from bumpless_server.plan.exchange.route import NotImportable

LARGEST = 8_000_000  # bytes of one unpacked file
MOST_FILES = 1000


def parsed(data: bytes) -> Element:
    """The root of an XML text. Raises NotImportable, also for a document type with its entities."""
    imported("defusedxml", "console")
    from defusedxml import DefusedXmlException
    from defusedxml.ElementTree import fromstring

    if len(data) > LARGEST:
        raise NotImportable(f"is larger than {LARGEST} bytes")
    try:
        return fromstring(data, forbid_dtd=True)
    except DefusedXmlException:
        raise NotImportable("holds a document type or entities, which no mission needs") from None
    except (ParseError, ValueError, LookupError, RecursionError) as error:
        raise NotImportable(f"is not valid XML: {error}") from None


def unpacked(data: bytes, *endings: str) -> tuple[str, bytes]:
    """(name, content) of the archive's first file with one of these endings. Raises NotImportable."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            names = archive.namelist()
            if len(names) > MOST_FILES:
                raise NotImportable(f"is an archive of {len(names)} files")
            name = next((n for n in names if n.lower().endswith(endings)), None)
            if name is None:
                raise NotImportable(f"is a ZIP archive without a {' or '.join(endings)} file in it")
            with archive.open(name) as file:
                content = file.read(LARGEST + 1)  # what the archive says of sizes may be a lie
    except (zipfile.BadZipFile, RuntimeError, NotImplementedError, OSError, EOFError, ValueError) as error:
        if isinstance(error, NotImportable):
            raise
        raise NotImportable(f"is no ZIP archive that can be read: {error}") from None
    if len(content) > LARGEST:
        raise NotImportable(f"holds a file that is larger than {LARGEST} bytes when unpacked")
    return name, content


def local_name(element: Element) -> str:
    """An element's name without its namespace."""
    return str(element.tag).rpartition("}")[2]
