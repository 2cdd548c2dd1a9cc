from joint_walks import photo
from skyline_viewshed.benchmarks import bench_joint


def row(alone, together, status="accepted", covered=True):
    both = {"alone": (alone, "accepted"), "together": (together, status)}
    return {way: {"error_deg": error, "status": said, "covered": covered} for way, (error, said) in both.items()}


def test_what_becomes_right_and_what_gets_worse_is_counted():
    rows = [row(40.0, 0.5), row(0.1, 0.2, covered=False), row(-1.0, 5.0), row(None, None, "failed")]
    assert bench_joint.counts(rows) == {
        "photos": 4, "< 0.5 together": 1, "< 1 together": 2,
        "right alone": 2, "right together": 2, "accepted alone": 4, "accepted together": 3,
        "accepted but wrong": 1, "worse": 1, "interval holds": 3, "of accepted ones": 2,
    }  # fmt: skip


def test_neighbours_are_near_in_space_or_of_the_same_camera_in_time():
    photos = [
        photo("a.jpg", "accepted", minutes=0, longitude_deg=8.0, latitude_deg=46.0),
        photo("b.jpg", "accepted", minutes=500, longitude_deg=8.0015, latitude_deg=46.001, device="Other"),
        photo("c.jpg", "accepted", minutes=1000, longitude_deg=9.0, latitude_deg=46.0),
        photo("d.jpg", "accepted", minutes=1059, longitude_deg=10.0, latitude_deg=46.0),
        photo("e.jpg", "accepted", minutes=1020, longitude_deg=11.0, latitude_deg=46.0, device=None),
    ]
    assert bench_joint.neighboured(photos) == [True, True, True, True, False]
