"""Pictures and pages equal the program's, byte by byte."""

import pathlib
import struct
import tempfile
import unittest
import zlib

import numpy as np
import scb
from support import BRACKET, moved, plate, run_scb, tetrahedron

SIZE = dict(size=(480, 360))


def chunks(png):
    at = 8
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        yield kind, png[at + 8:at + 8 + length]
        at += 12 + length


def pixel_data(png):
    return b"".join(data for kind, data in chunks(png) if kind == b"IDAT")


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def drawn(self, *arguments):
        """The one picture of a command."""
        run_scb("render", *arguments, "--size", "480x360", "-o", self.folder)
        (file,) = self.folder.glob("*.png")
        png = file.read_bytes()
        file.unlink()
        (self.folder / "index.json").unlink()
        return png

    def test_of_levels_are_those_of_the_program(self):
        for options, arguments in (
            (dict(level=4), ["--levels", 4]),
            (dict(level="leaves", volume="obb", frame=85, mesh=True, color_by="depth"),
             ["--levels", "leaves", "--volume", "obb", "--frame", 85, "--mesh", "--color-by", "depth"]),
            (dict(level=2, camera="orbit:10,20", orthographic=True, background="dark", samples=1, panel=False),
             ["--levels", 2, "--camera", "orbit:10,20", "--ortho", "--background", "dark", "--samples", 1,
              "--no-panel"]),
        ):
            image = scb.draw_level(BRACKET, **options, **SIZE)
            self.assertEqual(pixel_data(image.png()), pixel_data(self.drawn("levels", BRACKET, *arguments)))

    def test_of_pairs_are_those_of_the_program(self):
        for options, arguments in (
            (dict(frame=85), ["--frame", 85]),
            (dict(frame=85, leaves=True, volume="scb2"),
             ["--frame", 85, "--leaves", "--volume", "scb2"]),
            (dict(camera="contact"), ["--camera", "contact"]),
        ):
            image = scb.draw_pairs(str(BRACKET), **options, **SIZE)
            self.assertEqual(pixel_data(image.png()), pixel_data(self.drawn("pairs", BRACKET, *arguments)))

    def test_are_arrays_and_files(self):
        image = scb.draw_level(BRACKET, 3, **SIZE)
        self.assertEqual((image.array.shape, image.array.dtype), ((360, 480, 4), np.uint8))
        self.assertEqual(image._repr_png_(), image.png())
        image.save(self.folder / "a.png")
        self.assertEqual((self.folder / "a.png").read_bytes(), image.png())
        # Its rows, as PNG has them: without a filter, or with one that is undone here.
        self.assertGreater(len(zlib.decompress(pixel_data(image.png()))), 360 * 480 * 3)

    def test_of_a_scene_of_ones_own_are_those_of_its_file(self):
        scene = scb.load_scene(BRACKET)
        poses = {name: scene.poses(name) for name in scene.bodies}
        own = scb.Scene({name: scene.mesh(name) for name in scene.bodies}, poses, scene.name)
        view = dict(camera="orbit:30,20", up="z", panel=False)
        for options in (dict(frame=85), dict(frame=99, volume="obb")):
            np.testing.assert_array_equal(scb.draw_pairs(own, **options, **view, **SIZE).array,
                                          scb.draw_pairs(scene, **options, **view, **SIZE).array)
            np.testing.assert_array_equal(scb.draw_level(own, 3, **options, **view, **SIZE).array,
                                          scb.draw_level(scene, 3, **options, **view, **SIZE).array)

    def test_pages_are_those_of_the_program(self):
        for options, arguments in (
            (dict(), []),
            (dict(volume="scb,obb", frame=85, level=5, test="corrected", threshold=0.5, color_by="depth"),
             ["--volume", "scb,obb", "--frame", 85, "--level", 5, "--test", "corrected", "--threshold", 0.5,
              "--color-by", "depth"]),
            (dict(compare="corrected,printed", frame=85, steps=10),
             ["--compare", "corrected,printed", "--frame", 85, "--steps", 10]),
        ):
            run_scb("view", BRACKET, *arguments, "-o", self.folder / "page.html")
            page = scb.view(BRACKET, **options)
            self.assertEqual(page.html, (self.folder / "page.html").read_text())
            page.save(self.folder / "same.html")
            self.assertEqual((self.folder / "same.html").read_text(), page.html)

    def test_pages_of_a_scene_of_ones_own_name_no_command(self):
        own = scb.Scene({"plate": plate(), "tetrahedron": tetrahedron()}, {"tetrahedron": moved(0.1, 0.2, -0.5)})
        page = scb.view(own, volume="scb,obb")
        for command in ('"scb render', '"scb explain'):
            self.assertNotIn(command, page.html)
            self.assertIn(command, scb.view("spheres-l1", frame=100).html)
        html = page._repr_html_()
        self.assertTrue(html.startswith('<iframe sandbox="allow-scripts allow-downloads"'))
        self.assertEqual(html.count('"'), 6)  # no more of them: the page is one attribute


if __name__ == "__main__":
    unittest.main()
