"""Everything that stands for a shape is the same shape."""

import types
import unittest

import numpy as np
import shapes

import shellmatch

try:
    import meshio
except ImportError:
    meshio = None

options = {"levels": (3, 3), "align": "none"}


def flat(faces):
    """As pyvista has them."""
    return np.concatenate([np.r_[len(face), face] for face in faces])


class Inputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = shapes.sphere(10)
        cls.template = shapes.sphere(10, (1.0, 0.8, 1.3))
        cls.expected = shellmatch.register((cls.vertices, cls.faces), cls.template, **options).vertices

    def same(self, reference):
        self.assertTrue(np.array_equal(shellmatch.register(reference, self.template, **options).vertices, self.expected))

    def test_types_and_orders_of_memory(self):
        wide = np.zeros((len(self.vertices), 6))
        wide[:, ::2] = self.vertices
        for vertices in (self.vertices.tolist(), np.asfortranarray(self.vertices), wide[:, ::2], self.vertices.astype(">f8")):
            self.same((vertices, self.faces))
        for faces in (
            self.faces.tolist(),
            self.faces.astype(np.int32),
            self.faces.astype(np.uint64),
            np.asfortranarray(self.faces),
            self.faces.astype(">i4"),
        ):
            self.same((self.vertices, faces))
        single = shellmatch.register((self.vertices.astype(np.float32), self.faces), self.template, **options)
        self.assertLess(np.abs(single.vertices - self.expected).max(), 1e-4)

    def test_polygons(self):
        """Quads, and polygons of several sizes, are those of a file."""
        quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
        corners = np.array([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)])[[0, 4, 2, 6, 1, 5, 3, 7]]
        by_array = shellmatch.register((corners, quads), (corners * (1, 1, 1.2), quads), **options)
        mixed = [quads[0].tolist()[:3], [0, 3, 1]] + quads[1:].tolist()
        by_list = shellmatch.register((corners, mixed), (corners * (1, 1, 1.2), quads), **options)
        self.assertLess(np.abs(by_array.vertices - by_list.vertices).max(), 1e-6)

    def test_objects_like_those_of_trimesh(self):
        self.same(types.SimpleNamespace(vertices=self.vertices, faces=self.faces))

    def test_objects_like_those_of_pyvista(self):
        self.same(types.SimpleNamespace(points=self.vertices, faces=flat(self.faces), cells=None))

    def test_objects_like_those_of_meshio(self):
        block = types.SimpleNamespace(type="triangle", data=self.faces)
        corner = types.SimpleNamespace(type="vertex", data=np.array([[0]]))
        self.same(types.SimpleNamespace(points=self.vertices, cells=[corner, block]))
        self.same(
            types.SimpleNamespace(points=self.vertices, cells=[("triangle", self.faces[:100]), ("triangle", self.faces[100:])])
        )

    @unittest.skipIf(meshio is None, "meshio is not installed")
    def test_meshio(self):
        self.same(meshio.Mesh(self.vertices, [("triangle", self.faces)]))

    def test_outlines_of_meshio(self):
        ring, n = shapes.ellipse(60, 1.2, 0.8), 60
        lines = np.stack([np.arange(n), (np.arange(n) + 1) % n], axis=1)
        expected = shellmatch.register(ring, shapes.ellipse(60), **options).vertices
        for points in (ring, np.c_[ring, np.zeros(n)]):
            mesh = types.SimpleNamespace(points=points, cells=[("line", lines)])
            self.assertTrue(np.array_equal(shellmatch.register(mesh, shapes.ellipse(60), **options).vertices, expected))

    def test_vertices_of_segments_keep_their_order(self):
        """Those of no segment, too: they move by the map. Numbers of landmarks are those of the array."""
        ring, template, n = shapes.ellipse(60, 1.2, 0.8), shapes.ellipse(60), 60
        places = np.random.default_rng(4).permutation(n + 5)[:n]
        vertices = np.full((n + 5, 2), 0.25)
        vertices[places] = ring
        segments = np.stack([places, np.roll(places, -1)], axis=1)
        expected = shellmatch.register(ring, template, **options).vertices
        lines = types.SimpleNamespace(points=np.c_[vertices, np.zeros(n + 5)], cells=[("line", segments)])
        for given in ((vertices, segments), lines):
            result = shellmatch.register(given, template, **options)
            self.assertTrue(np.array_equal(result.vertices[places], expected))
            self.assertTrue(np.array_equal(result.vertices, result.apply(vertices)))
        chosen, landmarks = np.array([0, 20, 40]), {**options, "landmarks.weight": 5, "landmarks.max_distance": 0.2}
        by_number = shellmatch.register((vertices, segments), template, (places[chosen], template[chosen + 3]), **landmarks)
        by_place = shellmatch.register((vertices, segments), template, (ring[chosen], template[chosen + 3]), **landmarks)
        self.assertTrue(np.array_equal(by_number.vertices, by_place.vertices))
        self.assertFalse(np.array_equal(by_number.vertices[places], expected))

    def test_a_point_repeated_at_the_end_of_a_ring_stays(self):
        ring, template = shapes.ellipse(60, 1.2, 0.8), shapes.ellipse(60)
        expected = shellmatch.register(ring, template, **options).vertices
        closed, places = np.vstack([ring, ring[:1]]), np.r_[np.arange(60), 0]
        result = shellmatch.register(closed, np.vstack([template, template[:1]]), **options)
        self.assertTrue(np.array_equal(result.vertices, expected[places]))
        self.assertEqual(len(result.distances.template_to_deformed), 61)
        self.assertIn("reference: 1 repeated point left out", result.notes)
        hole = shapes.ellipse(40, 0.4, 0.4)[::-1]
        two = shellmatch.register([closed, hole], [template, hole], **options)
        self.assertTrue(np.array_equal(two.vertices[60], two.vertices[0]))
        self.assertTrue(np.array_equal(two.vertices, two.apply(np.vstack([closed, hole]))))

    def test_masked_values_are_no_values(self):
        mask = np.zeros(self.vertices.shape, bool)
        self.same((np.ma.array(self.vertices, mask=mask), np.ma.array(self.faces)))
        mask[7, 1] = True
        masked, some = np.ma.array(self.vertices, mask=mask), np.ma.masked_equal(np.eye(6)[None].repeat(6, 0), 1)
        faces = np.ma.masked_equal(self.faces, 5)
        for wrong in (
            (masked, self.faces),
            (self.vertices, faces),
            types.SimpleNamespace(vertices=masked, faces=self.faces),
            types.SimpleNamespace(points=self.vertices, cells=[("triangle", faces)]),
            shellmatch.Volume(some),
            [np.ma.masked_less(shapes.ellipse(40), 0)],
        ):
            with self.assertRaisesRegex(shellmatch.InputError, "fill it first"):
                shellmatch.register(wrong, self.template, **options)

    def test_images_like_those_of_nibabel(self):
        i, j, k = np.meshgrid(*[np.arange(18)] * 3, indexing="ij")
        values = ((i - 9) ** 2 + (j - 9) ** 2 + (k - 9) ** 2 < 36).astype(np.uint8)
        image = types.SimpleNamespace(dataobj=values, affine=np.diag([2.0, 2, 2, 1]))
        a = shellmatch.register(shellmatch.Volume(image), shellmatch.Volume(values, image.affine, label=1), **options)
        b = shellmatch.register(shellmatch.Volume(values, image.affine), shellmatch.Volume(values, image.affine), **options)
        self.assertTrue(np.array_equal(a.vertices, b.vertices))

    def test_several_rings(self):
        outer, hole = shapes.ellipse(80), shapes.ellipse(40, 0.4, 0.4)[::-1]
        result = shellmatch.register([outer, hole], [outer * 1.1, hole * 1.2], **options)
        self.assertEqual(result.vertices.shape, (120, 2))

    def test_nothing_given_is_changed(self):
        vertices, faces = self.vertices.copy(), self.faces.copy()
        vertices.flags.writeable = faces.flags.writeable = False
        self.same((vertices, faces))


if __name__ == "__main__":
    unittest.main()
