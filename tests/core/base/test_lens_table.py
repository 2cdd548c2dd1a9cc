"""Which row of a table of lenses a photograph takes."""

import pytest
from skyline_viewshed.core.base.lens_table import LensRow, fitting_rows
from skyline_viewshed.core.base.model import PhotoMetadata


def photo(make="NIKON CORPORATION", model="NIKON D200", lens=None, focal_mm=20.0, f35=30.0):
    return PhotoMetadata(
        "a.jpg", 100, 80, make=make, model=model, lens=lens, focal_length_mm=focal_mm, focal_length_35mm=f35
    )


def fits(row, metadata):
    return fitting_rows([row], metadata) == [row]


@pytest.mark.parametrize("model", ["NIKON D200", "nikon  d200", "D200"])
@pytest.mark.parametrize("make", ["", "Nikon", "NIKON CORPORATION"])
def test_makers_and_models_are_recognised_as_people_write_them(make, model):
    assert fits(LensRow(1, make, model), photo())


@pytest.mark.parametrize(
    "row",
    [
        LensRow(1, make="Canon"),
        LensRow(1, model="D20"),
        LensRow(1, model="D200X"),
        LensRow(1, lens="AF 20mm"),
        LensRow(1, make="Nikon", model="D200", focal_mm=24.0),
        LensRow(1, focal_35mm=20.0),
    ],
)
def test_another_lens_does_not_fit(row):
    assert fitting_rows([row], photo()) == []


def test_what_the_file_does_not_say_does_not_fit():
    unknown = PhotoMetadata("a.jpg", 100, 80)
    for row in (LensRow(1, make="Nikon"), LensRow(1, model="D200"), LensRow(1, lens="x"), LensRow(1, focal_mm=20.0)):
        assert fitting_rows([row], unknown) == []


def test_a_maker_is_no_model():
    assert fitting_rows([LensRow(1, model="NIKON")], photo()) == []
    assert fits(LensRow(1, model="iPhone 15"), photo("Apple", "iPhone 15"))
    assert fitting_rows([LensRow(1, model="iPhone 15")], photo("Apple", "iPhone 15 Pro")) == []


def test_the_row_that_names_most_is_taken_then_the_nearest_focal_length():
    any_nikon, d200 = LensRow(1, make="Nikon", k1=0.1), LensRow(2, make="Nikon", model="D200", k1=0.2)
    at_20, at_205 = LensRow(3, model="D200", focal_mm=20.0), LensRow(4, model="D200", focal_mm=20.5)
    lens = LensRow(5, "Nikon", "D200", "AF Nikkor 20mm f/2.8D", 20.0)
    assert fitting_rows([any_nikon, d200], photo()) == [d200]
    assert fitting_rows([at_20, at_205], photo(focal_mm=20.1)) == [at_20]
    assert fitting_rows([at_20, at_205], photo(focal_mm=20.45)) == [at_205]
    assert fitting_rows([any_nikon, d200, at_20, lens], photo(lens="AF NIKKOR 20mm f/2.8D")) == [lens]
    assert fitting_rows([d200, at_20], photo()) == [d200, at_20]


def test_focal_lengths_may_be_rounded():
    iphone = photo("Apple", "iPhone 15", focal_mm=5.96, f35=26.0)
    assert fits(LensRow(1, model="iPhone 15", focal_mm=6.0, focal_35mm=26.0), iphone)
    assert fitting_rows([LensRow(1, model="iPhone 15", focal_mm=5.0)], iphone) == []
