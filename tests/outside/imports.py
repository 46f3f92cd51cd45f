"""What `cusp import` refuses before it makes anything: options in vain, files that it would pass over, names that mislead.
And how verbs name a tissue that an author named.

  imports.py CUSP
"""
import gzip
import os
import struct
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check, one_sentence  # noqa: E402


def options_in_vain(desk):
    """An option that changes nothing of what is imported is named, not ignored."""
    own, mesh, made = desk.path("made.nrrd"), desk.path("cube.obj"), desk.path("vain.nrrd")
    check(desk.run("specimen", "block", "--voxel-mm", "0.5", "-o", own)[0] == 0, "a block is made")
    for file, *option in ((own, "--up", "x"), (own, "--unit-mm", "1"), (own, "--scale", "2"), (own, "--voxel-mm", "0.2"), (own, "--tissue", "2=enamel"),
                          (own, "--from", "dentine=3"), (own, "--hollows", "pulp"), (own, "--largest-piece"), (own, "--mend-mm", "1"),
                          (own, "--precedence", "given"), (mesh, "--largest-piece"), (mesh, "--hollows", "pulp"), (mesh, "--from", "dentine=3"),
                          (desk.path("ct.mha"), "--mend-mm", "1"), (desk.path("ct.mha"), "--precedence", "given")):
        status, out, err = desk.run("import", file, *option, "-o", made)
        check(status == 2 and out == "" and option[0] in err, f"{file} {option}: exit {status}: {out}{err}")
        one_sentence(err, str(option))
    check(not os.path.exists(made), "a refused import left a volume")
    status, _, err = desk.run("import", own, "--turn", "z", "-o", made)
    check(status == 0 and os.path.exists(made), f"a specimen is turned: {err}")


def wrong_usage(desk, what, arguments, name):
    status, out, err = desk.run("import", *arguments)
    check(status == 2 and out == "" and name in err, f"{what}: exit {status}: {out}{err}")
    one_sentence(err, what)


def failed(desk, what, arguments, name):
    status, out, err = desk.run("import", *arguments)
    check(status == 1 and out == "" and name in err, f"{what}: exit {status}: {out}{err}")
    one_sentence(err, what)


def one_part(desk):
    """A tetrahedron, and a volume that is label 1 throughout."""
    mesh, labels = desk.path("part.obj"), desk.path("labels.nrrd")
    with open(mesh, "w", encoding="ascii") as f:
        f.write("o a\nv 0 0 0\nv 5 0 0\nv 0 5 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    with open(labels, "wb") as f:
        f.write(b"NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 4 4\nspacings: 1 1 1\nencoding: raw\n\n" + b"\1" * 64)
    return mesh, labels


def passed_over(desk, mesh, labels):
    """A file or a label that would not be read is named."""
    made, tissue = desk.path("imported.nrrd"), ("--tissue", "1=enamel")
    for other in (mesh, labels):
        wrong_usage(desk, f"{other} beside a volume", (labels, other, *tissue, "-o", made), other)
    wrong_usage(desk, "a list into a file", (mesh, "--list", "-o", made), "--output")
    wrong_usage(desk, "a list of tissues", (mesh, "--list", "--tissue", "a=enamel"), "--tissue")
    failed(desk, "a folder that is not there", (desk.path("scans") + "/", "--list"), "scans")
    os.mkdir(desk.path("scans"))
    failed(desk, "a folder without slices", (desk.path("scans") + "/", "--from", "dentine=1200", "-o", made), "scans")
    failed(desk, "a label that is not there", (labels, *tissue, "--tissue", "3=pulp", "-o", made), "3")
    check(not os.path.exists(made), "a refused import left a volume")


def names(desk, mesh, labels):
    """A volume lies under a name of its own kind, and no source of it is lost."""
    with open(labels, "rb") as f:
        before = f.read()
    for name in ("tooth.stl", "tooth.nii.gz", "tooth.mha"):
        wrong_usage(desk, name, (labels, "--tissue", "1=enamel", "-o", desk.path(name)), name)
        check(not os.path.exists(desk.path(name)), f"{name} was written")
    wrong_usage(desk, "over a mesh", (mesh, "--tissue", "a=enamel", "-o", mesh), "part.obj")
    failed(desk, "over its own source", (labels, "--tissue", "1=enamel", "-o", labels), "labels.nrrd")
    with open(labels, "rb") as f:
        check(f.read() == before, "a refused import wrote over its source")
    capital = desk.path("tooth.BINVOX")
    status, _, err = desk.run("import", labels, "--tissue", "1=enamel", "-o", capital)
    check(status == 0, f"a binvox in capitals: {err}")
    with open(capital, "rb") as f:
        check(f.read(7) == b"#binvox", "a binvox in capitals is none")
    own = desk.path("own.nrrd")
    check(desk.run("specimen", "block", "--voxel-mm", "0.5", "-o", own)[0] == 0, "a block is made")
    status, _, err = desk.run("import", own, "--turn", "z", "-o", own)
    check(status == 0, f"a specimen is turned in its place: {err}")


def own_tissue(desk):
    """A tissue that the author named stands by that name in what people read, and by its code in JSON."""
    stone, turned = desk.path("stone.nrrd"), desk.path("turned.nrrd")
    header = ("NRRD0005\ntype: uint16\ndimension: 4\nspace: right-anterior-superior\nsizes: 2 8 8 8\n"
              "space directions: none (0.5,0,0) (0,0.5,0) (0,0,0.5)\ncenterings: none cell cell cell\nkinds: list space space space\n"
              "endian: little\nencoding: raw\nspace origin: (0,0,0)\nspace units: \"mm\" \"mm\" \"mm\"\ntissue 16:=pulp stone\n\n")
    with open(stone, "wb") as f:
        f.write(header.encode("ascii") + struct.pack("<HH", 16, 65535) * 512)
    status, out, err = desk.run("import", stone, "--turn", "z", "-o", turned)
    check(status == 0 and "pulp stone: " in out, f"a named tissue: exit {status}: {out}{err}")
    check(desk.json("import", stone, "--turn", "z", "-o", turned)["tissues"] == ["16"], "a script needs the code")
    firm = desk.path("firm.nrrd")
    with open(firm, "wb") as f:
        f.write(header.replace("tissue 16", "tissue 31").encode("ascii") + struct.pack("<HH", 31, 65535) * 512)
    failed(desk, "a code that means firm caries", (firm, "--turn", "z", "-o", desk.path("firm-turned.nrrd")), "pulp stone")
    check(not os.path.exists(desk.path("firm-turned.nrrd")), "a refused import left a volume")

    def on_the_stone(scenario):
        scenario["specimen"] = {"volume": "stone.nrrd", "voxel_mm": 0.5}

    exercise = desk.small_exercise("stone.json", on_the_stone)
    status, out, _ = desk.run("validate", exercise)
    check(status == 1 and "(pulp stone)" in out and "(Plastic)" in out, f"a named tissue that is not described: exit {status}: {out}")

    def on_firm_stone(scenario):
        scenario["specimen"] = {"volume": "firm.nrrd", "voxel_mm": 0.5}

    status, _, err = desk.run("validate", desk.small_exercise("firm.json", on_firm_stone))
    check(status == 1 and "the tissue pulp stone has the code" in err, f"an exercise with a code that means firm caries: exit {status}: {err}")


def removed_own_tissue(desk):
    """What an attempt removed of it stands by that name too."""
    block, database = desk.path("block.nrrd"), desk.path("stone.db")
    check(desk.run("specimen", "block", "--voxel-mm", "0.25", "-o", block)[0] == 0, "a block is made")
    with open(block, "rb") as f:
        header, packed = f.read().split(b"\n\n", 1)
    voxels = bytearray(gzip.decompress(packed))
    voxels[0::4] = voxels[0::4].replace(b"\x0b", b"\x10")  # the low byte of each voxel's tissue: 11, plastic, becomes 16
    with open(block, "wb") as f:
        f.write(header.replace(b"tissue 11:=plastic", b"tissue 16:=pulp stone") + b"\n\n" + gzip.compress(bytes(voxels), 1))

    def of_stone(scenario):
        scenario["specimen"] = {"volume": "block.nrrd", "voxel_mm": 0.25}
        scenario["tissues"][0]["tissue"] = "16"
        bands = {"fail_lo": 0, "acc_lo": 0, "ideal_lo": 0, "ideal_hi": 1, "acc_hi": 2, "fail_hi": 3}
        scenario["rubric"]["criteria"].append({"metric": "removed_16", "weight": 1, "bands": bands})

    status, _, err = desk.run("play", desk.small_exercise("of-stone.json", of_stone), "--script", desk.small_script(2), "--db", database,
                              "--out", desk.path("stone"))
    check(status == 0, f"a block of stone is drilled: exit {status}: {err}")
    (row,) = desk.json("history", database, "list")
    status, out, err = desk.run("history", database, "show", row["session"])
    check(status == 0 and "  pulp stone: " in out and "  pulp stone removed: " in out and "Material 1" not in out,
          f"what was removed: exit {status}: {out}{err}")


with Desk(sys.argv[1]) as the_desk:
    options_in_vain(the_desk)
    passed_over(the_desk, *one_part(the_desk))
    names(the_desk, *one_part(the_desk))
    own_tissue(the_desk)
    removed_own_tissue(the_desk)
