"""What a notebook shows of a photograph."""

from skyline_viewshed.core.base.errors import MissingPackageError
from skyline_viewshed.core.figures import notebook


def test_the_overlay_stands_above_the_facts(painted):
    page = notebook.photo_html(painted())
    assert page.startswith('<img src="data:image/jpeg;base64,') and page.endswith("</div>")
    assert "accepted, heading 123.40°" in page


def test_without_a_picture_there_are_the_facts(painted, monkeypatch):
    assert "<img" not in notebook.photo_html(painted(preview=None))

    def missing(*arguments):
        raise MissingPackageError("no Pillow")

    monkeypatch.setattr(notebook, "overlay_image", missing)
    page = notebook.photo_html(painted())
    assert "<img" not in page and "heading 123.40°" in page


def test_a_hostile_name_is_escaped(painted):
    page = notebook.photo_html(painted(path="/x/<script>alert(1).jpg", preview=None))
    assert "<script>" not in page and "&lt;script&gt;" in page
