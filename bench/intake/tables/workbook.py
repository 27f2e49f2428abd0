# SPDX-License-Identifier: GPL-3.0-or-later
"""A minimal .xlsx writer, so that the same seed gives the same bytes everywhere."""
import io
import zipfile
from xml.sax.saxutils import escape

TYPES = ('<?xml version="1.0" encoding="UTF-8" standalone="yes"?>'
         '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
         '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
         '<Default Extension="xml" ContentType="application/xml"/>'
         '<Override PartName="/xl/workbook.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/>'
         '<Override PartName="/xl/styles.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.styles+xml"/>'
         '{}</Types>')
SHEET_TYPE = ('<Override PartName="/xl/worksheets/sheet{}.xml" '
              'ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml"/>')
RELS = ('<?xml version="1.0" encoding="UTF-8" standalone="yes"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/'
        'relationships">{}</Relationships>')
REL = '<Relationship Id="rId{}" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/{}" Target="{}"/>'
MAIN = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'
STYLES = (f'<?xml version="1.0" encoding="UTF-8" standalone="yes"?><styleSheet {MAIN}>'
          '<numFmts count="1"><numFmt numFmtId="164" formatCode="yyyy\\-mm\\-dd\\ hh:mm:ss"/></numFmts>'
          '<fonts count="1"><font><sz val="11"/><name val="Calibri"/></font></fonts>'
          '<fills count="2"><fill><patternFill patternType="none"/></fill><fill><patternFill patternType="gray125"/></fill></fills>'
          '<borders count="1"><border/></borders><cellStyleXfs count="1"><xf/></cellStyleXfs>'
          '<cellXfs count="2"><xf numFmtId="0"/><xf numFmtId="164" applyNumberFormat="1"/></cellXfs></styleSheet>')


def letters(index):
    name = ""
    index += 1
    while index:
        index, rest = divmod(index - 1, 26)
        name = chr(65 + rest) + name
    return name


class Date(float):
    """Serial days, shown as a date."""


def cell_xml(reference, value):
    if isinstance(value, Date):
        return f'<c r="{reference}" s="1"><v>{float(value):.10f}</v></c>'
    if isinstance(value, (int, float)):
        return f'<c r="{reference}"><v>{value!r}</v></c>'
    if value.startswith("#"):
        return f'<c r="{reference}" t="e"><v>{escape(value)}</v></c>'
    return f'<c r="{reference}" t="inlineStr"><is><t xml:space="preserve">{escape(value)}</t></is></c>'


def sheet_xml(rows, merged):
    out = [f'<?xml version="1.0" encoding="UTF-8" standalone="yes"?><worksheet {MAIN}><sheetData>']
    for number, row in enumerate(rows, 1):
        cells = "".join(cell_xml(f"{letters(i)}{number}", value) for i, value in enumerate(row) if value != "")
        if cells:
            out.append(f'<row r="{number}">{cells}</row>')
    out.append("</sheetData>")
    if merged:
        out.append(f'<mergeCells count="{len(merged)}">' + "".join(f'<mergeCell ref="{m}"/>' for m in merged) + "</mergeCells>")
    out.append("</worksheet>")
    return "".join(out)


def workbook(sheets, merged=()):
    """Bytes of a workbook: [(name, rows)], `merged` ranges in the last sheet. A row is a list of numbers, Dates and strings."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as book:
        def write(name, text):
            book.writestr(zipfile.ZipInfo(name, (2026, 1, 1, 0, 0, 0)), text)
        count = len(sheets)
        write("[Content_Types].xml", TYPES.format("".join(SHEET_TYPE.format(i) for i in range(1, count + 1))))
        write("_rels/.rels", RELS.format(REL.format(1, "officeDocument", "xl/workbook.xml")))
        names = "".join(f'<sheet name="{escape(name)}" sheetId="{i}" r:id="rId{i}"/>' for i, (name, _) in enumerate(sheets, 1))
        write("xl/workbook.xml", f'<?xml version="1.0" encoding="UTF-8" standalone="yes"?><workbook {MAIN} '
              f'xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets>{names}</sheets></workbook>')
        relations = [REL.format(i, "worksheet", f"worksheets/sheet{i}.xml") for i in range(1, count + 1)]
        write("xl/_rels/workbook.xml.rels", RELS.format("".join(relations) + REL.format(count + 1, "styles", "styles.xml")))
        write("xl/styles.xml", STYLES)
        for i, (_, rows) in enumerate(sheets, 1):
            write(f"xl/worksheets/sheet{i}.xml", sheet_xml(rows, merged if i == count else ()))
    return out.getvalue()
