"""`make release` on a scratch clone: one commit, one tag, the packages; or nothing at all."""

import subprocess
from pathlib import Path

import pytest

import release

ROOT = Path(__file__).resolve().parents[2]
NEXT = "99.1.0"


def git(folder: Path, *arguments: str) -> str:
    """What git says in `folder`."""
    done = subprocess.run(["git", *arguments], cwd=folder, check=True, capture_output=True, text=True)
    return done.stdout.strip()


@pytest.fixture
def clone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A clone of this repository with something to release; console and checks are left out."""
    folder = tmp_path / "clone"
    git(tmp_path, "clone", "--quiet", "--shared", str(ROOT), str(folder))
    git(folder, "config", "user.name", "Releaser")
    git(folder, "config", "user.email", "releaser@example.org")
    changes = folder / "CHANGELOG.md"
    changes.write_text(
        "# Changelog\n\n## Unreleased\n\n- A change.\n\n## 0.0.1 (2026-01-01)\n\n- An old one.\n"
    )
    git(folder, "commit", "--quiet", "--all", "--allow-empty", "--message", "Change something")
    monkeypatch.setenv("BUMPLESS_SKIP_CONSOLE", "1")
    monkeypatch.setattr(release, "ROOT", folder)
    monkeypatch.setattr(release, "PROJECT", folder / "pyproject.toml")
    monkeypatch.setattr(release, "CHANGELOG", changes)
    monkeypatch.setattr(release, "CHECKS", ("true",))
    return folder


def test_a_release_is_a_commit_a_tag_and_packages(clone: Path) -> None:
    """Protects: version, changelog, tag and wheel say the same."""
    assert release.main([NEXT]) == 0
    assert git(clone, "status", "--porcelain") == ""
    assert git(clone, "log", "-1", "--format=%s") == f"Release {NEXT}"
    assert git(clone, "rev-parse", f"v{NEXT}^{{commit}}") == git(clone, "rev-parse", "HEAD")
    assert f'version = "{NEXT}"' in (clone / "pyproject.toml").read_text()
    chapters = (clone / "CHANGELOG.md").read_text().split("\n## ")
    assert [chapter.split(" ")[0].strip() for chapter in chapters[1:]] == ["Unreleased", NEXT, "0.0.1"]
    assert "- A change." in chapters[2]
    assert {path.name for path in (clone / "dist").iterdir()} == {
        f"bumpless-{NEXT}-py3-none-any.whl",
        f"bumpless-{NEXT}.tar.gz",
    }
    assert release.main([NEXT]) == 1


@pytest.mark.parametrize("version", ["1.2", "v1.2.3", "0.0.1", ""])
def test_a_version_that_is_none_or_old_is_refused(clone: Path, version: str) -> None:
    """Protects: versions only grow."""
    assert refused(clone, version)


def test_a_tree_that_is_not_clean_is_refused(clone: Path) -> None:
    """Protects: what is released is what is committed."""
    (clone / "new.txt").write_text("not committed")
    assert refused(clone, NEXT)


def test_without_a_word_in_the_changelog_there_is_no_release(clone: Path) -> None:
    """Protects: each release tells its users what changed."""
    (clone / "CHANGELOG.md").write_text(
        "# Changelog\n\n## Unreleased\n\n## 0.0.1 (2026-01-01)\n\n- An old one.\n"
    )
    git(clone, "commit", "--quiet", "--all", "--message", "Say nothing")
    assert refused(clone, NEXT)


def test_a_failing_check_or_build_leaves_nothing_behind(clone: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects: no half release."""
    monkeypatch.setattr(release, "CHECKS", ("false",))
    assert refused(clone, NEXT)
    monkeypatch.setattr(release, "CHECKS", ("true",))
    monkeypatch.setattr(release, "build", lambda: subprocess.run(["false"], check=True))
    assert refused(clone, NEXT)


def refused(clone: Path, version: str) -> bool:
    """True when the release ends with 1 and neither commit nor tag nor tree has changed."""
    before = [git(clone, "rev-parse", "HEAD"), git(clone, "tag"), git(clone, "status", "--porcelain")]
    code = release.main([version])
    after = [git(clone, "rev-parse", "HEAD"), git(clone, "tag"), git(clone, "status", "--porcelain")]
    return code == 1 and before == after
