"""What a notebook shows: a picture (_repr_png_), and a page to turn and to ask (_repr_html_)."""

import scb

scene = scb.load_scene("spheres-l1")
picture = scb.draw_pairs(scene, 250, size=(640, 480))
page = scb.view(scene, frame=250, level=6, volume="scb,obb")

# In a notebook the last line of a cell is shown: `picture`, or `page`. Elsewhere they can be saved.
picture.save("pairs.png")
page.save("spheres.html")
print(picture, picture.array.shape, len(picture._repr_png_()) > 10_000)
print(page._repr_html_().startswith("<iframe"))
