"""Several files as one answer: a zip."""

import io
import zipfile
from collections.abc import Mapping
from functools import partial

from starlette.responses import Response

ZIP = {"application/zip": {"schema": {"type": "string", "format": "binary"}}}
"""The content of such an answer, in the OpenAPI document."""
_MOMENT = (1980, 1, 1, 0, 0, 0)
"""Time of every file in an archive: the same request gives the same bytes."""


def archive(files: Mapping[str, bytes], name: str, headers: Mapping[str, str]) -> Response:
    """A zip of files. The same files give the same bytes."""
    buffer = io.BytesIO()
    entry = partial(zipfile.ZipInfo, date_time=_MOMENT)
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as packed:
        for path, data in files.items():
            packed.writestr(entry(path), data, zipfile.ZIP_DEFLATED)
    disposition = {"Content-Disposition": f'attachment; filename="{name}"'}
    return Response(buffer.getvalue(), media_type="application/zip", headers={**headers, **disposition})
