#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_tables.py ROWS CSV XLSX: one record of 20 columns, eight that are read and twelve that are not, as CSV and as a workbook."""
import math, sys, zipfile

READ = ["time_s", "axial_displacement_mm", "axial_force_kN", "cell_pressure_kPa", "back_pressure_kPa",
        "pore_pressure_kPa", "back_volume_mm3", "cell_volume_mm3"]
HEADINGS = READ + [f"spare_{i}" for i in range(1, 13)]
LETTERS = [chr(ord("A") + i) for i in range(len(HEADINGS))]
BOOK = {
    "[Content_Types].xml": '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"/>',
    "xl/workbook.xml": '<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" '
                       'xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships">'
                       '<sheets><sheet name="Data" sheetId="1" r:id="rId1"/></sheets></workbook>',
    "xl/_rels/workbook.xml.rels": '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">'
                                  '<Relationship Id="rId1" Type="http://schemas.openxmlformats.org/officeDocument/2006/'
                                  'relationships/worksheet" Target="worksheets/sheet1.xml"/></Relationships>',
}


def cells(i):
    t = i * 0.1
    fall = math.exp(-t / 4e4)
    noise = ((i * 7919) % 997 - 498) * 1e-6
    out = [f"{t:.1f}", f"{t * 1e-4 + noise:.5f}", f"{0.2 * fall + noise:.6f}", f"{600 + noise * 1e3:.3f}",
           f"{300 - noise * 1e3:.3f}", f"{300 + 50 * (1 - fall) + noise * 1e3:.3f}", f"{noise * 1e4:.2f}", f"{noise * 2e4:.2f}"]
    return out + [f"{(i * k) % 10007 * 1e-3:.3f}" for k in range(1, 13)]


rows, csv_path, xlsx_path = int(sys.argv[1]), sys.argv[2], sys.argv[3]
with open(csv_path, "w") as csv, zipfile.ZipFile(xlsx_path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as book:
    for name, text in BOOK.items():
        book.writestr(name, text)
    with book.open("xl/worksheets/sheet1.xml", "w", force_zip64=True) as sheet:
        sheet.write(b'<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData><row r="1">')
        sheet.write("".join(f'<c r="{c}1" t="inlineStr"><is><t>{h}</t></is></c>' for c, h in zip(LETTERS, HEADINGS)).encode())
        sheet.write(b"</row>")
        csv.write(",".join(HEADINGS) + "\n")
        for i in range(rows):
            row = cells(i)
            csv.write(",".join(row) + "\n")
            n = i + 2
            sheet.write((f'<row r="{n}">' + "".join(f'<c r="{c}{n}"><v>{v}</v></c>' for c, v in zip(LETTERS, row)) + "</row>").encode())
        sheet.write(b"</sheetData></worksheet>")
