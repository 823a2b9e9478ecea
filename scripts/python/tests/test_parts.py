# SPDX-FileCopyrightText: 2026 The Voussoir authors
# SPDX-License-Identifier: Apache-2.0
"""Cases as objects, by the words of the case file."""

import dataclasses
import inspect
import typing

import voussoir
from fixture import InAFolder, blocks
from voussoir import parts, toml, toml_reading
from voussoir.parts import (Base, Block, Case, Gravity, House, HouseOpening, HouseTie, JointLaw, Joints, JointsBetween, Load, Material, Output,
                            OutputHistory, Time, Wall, WallOpening, WallOpeningLintel)


def two_blocks():
    return Case(title="Two bonded blocks", gravity=Gravity(settle=False), time=Time(duration=0.1), base=Base(z=0.0),
                materials={"stone": Material(density=2000.0, young=1e8, poisson=0.2)},
                joint_laws={"mortar": JointLaw(tension=1e5, cohesion=1e5, friction=30.0, compression=1e6)}, joints=Joints(default="mortar"),
                block=[Block(name="lower", material="stone", box=[[0, 0, 0], [0.2, 0.2, 0.2]]),
                       Block(name="upper", material="stone", box=[[0, 0, 0.2], [0.2, 0.2, 0.4]])],
                output=Output(history=[OutputHistory(name="upper", point=[0.1, 0.1, 0.3])]))


class Parts(InAFolder):
    def test_a_case_is_that_of_the_same_words(self):
        model = blocks()
        model["motion"] = None
        of_objects = voussoir.Model.of(two_blocks())
        self.assertEqual(toml_reading.loads(of_objects.text()), toml_reading.loads(model.text()))
        self.assertEqual(voussoir.check(two_blocks()).elements, 2)
        self.assertTrue(voussoir.run(two_blocks(), self.folder / "run", until=0.01, threads=1, progress=False).finished)

    def test_a_wrong_word_is_a_type_error_at_once(self):
        with self.assertRaisesRegex(TypeError, "heigth"):
            Wall(name="a", heigth=2.0)
        with self.assertRaisesRegex(TypeError, "width"):
            WallOpening(from_=1.0, height=1.0)  # needs it
        with self.assertRaises(AttributeError):
            Time().duratoin = 3.0

    def test_values_are_checked_by_the_program(self):
        case = two_blocks()
        case.materials["stone"].density = -1.0
        with self.assertRaises(voussoir.InputError) as caught:
            voussoir.check(case)
        self.assertEqual(caught.exception.key, "materials.stone.density")

    def test_walls_and_openings_are_added(self):
        model = voussoir.Model("A wall", include=["parts/adobe-house", "parts/strong-mortar"])
        wall = Wall(name="garden", points=[[0, 0], [4, 0]], thickness=0.3, height=2.0, brick=[0.3, 0.15, 0.1], material="adobe",
                    opening=[WallOpening(from_=1.0, width=0.9, height=1.5, lintel=WallOpeningLintel(bearing=0.15, height=0.1, material="wood"))])
        self.assertIs(model.add(wall), model)
        model.add(dataclasses.replace(wall, name="other", points=[[0, 3], [4, 3]]), Load(block="x", force=[0, 0, -1.0]))
        self.assertEqual([one["name"] for one in model.case["wall"]], ["garden", "other"])
        self.assertEqual(model.case["wall"][0]["opening"][0]["from"], 1.0)
        self.assertEqual(model.case["wall"][0]["opening"][0]["lintel"]["bearing"], 0.15)
        self.assertEqual(len(model.case["load"]), 1)

    def test_a_table_that_stands_once_is_laid_over(self):
        model = voussoir.Model().add(House(height=2.0, bond="english"), House(height=3.0), HouseOpening(wall="front", from_=1.0, width=1.0, height=1.0))
        self.assertEqual((model["house.height"], model["house.bond"], len(model["house.opening"])), (3.0, "english", 1))
        model.add(HouseOpening(wall="rear", from_=1.0, width=1.0, height=1.0))
        model.add(HouseTie(name="rod", kind="along", walls=["front"], heights=[2.0], area=1e-4, yield_=2.5e8))
        self.assertEqual([one["wall"] for one in model["house.opening"]], ["front", "rear"])
        self.assertEqual(model["house.tie"][0]["yield"], 2.5e8)
        model.add(JointsBetween(materials=["stone", "base"], law="dry"))
        self.assertEqual(model["joints.between"], [{"materials": ["stone", "base"], "law": "dry"}])

    def test_what_needs_a_place(self):
        with self.assertRaisesRegex(TypeError, "needs a name"):
            voussoir.Model().add(Material(density=1.0))
        model = voussoir.Model().add(HouseOpening(wall="front", from_=1.0, width=1.0, height=1.0))
        with self.assertRaisesRegex(TypeError, r"one of several \[\[opening\]\]"):
            model.add(parts.HouseOpeningLintel(length=1.0))

    def test_files_are_named_from_anywhere(self):
        (self.folder / "x.csv").write_text("t [s],a [m/s2]\n0,0\n0.05,1\n")
        there = (self.folder / "x.csv").resolve()
        model = voussoir.Model().add(parts.Motion(x=str(there)), Case(include="flat20n"))
        self.assertEqual((model["motion.x"], model["include"]), (str(there), "flat20n"))

    def test_a_part_and_what_was_made_of_it_are_apart(self):
        point = [0.0, 0.0, 1.0]
        load = Load(block="a", force=point)
        model = voussoir.Model().add(load)
        point[2] = 5.0
        self.assertEqual(model["load"][0]["force"], [0.0, 0.0, 1.0])

    def test_every_class_has_types_and_words_with_units(self):
        for name in parts.__all__:
            one = getattr(parts, name)
            with self.subTest(name):
                hints = typing.get_type_hints(one)
                text = inspect.getdoc(one)
                for field in dataclasses.fields(one):
                    self.assertIn(field.name, hints)
                    self.assertIn(f"\n{field.name}", text)
        self.assertIn("height, m: ", inspect.getdoc(Wall))

    def test_arrays_of_numpy_are_values(self):
        import numpy as np
        self.assertIn("point = [1.0, 2.0, 3.0]", toml.document(OutputHistory(name="a", point=np.array([1.0, 2.0, 3.0])).keys()))
