"""What setuptools cannot know: the extension is built by CMake, of the same rooms as the program, and the package
brings the shaders, palettes and scenes."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PARTS_WITHOUT = {"shaders": (), "assets": ("guide",), "scenes": ("pictures", "*.md")}


class BuildByCMake(build_ext):
    def build_module(self) -> pathlib.Path:
        build = SOURCE / "build" / "python"
        subprocess.run(["cmake", "--preset", "release", "-S", SOURCE, "-B", build, "-DFUMON_PYTHON=ON",
                        f"-DPython_EXECUTABLE={sys.executable}"], check=True, cwd=SOURCE)
        subprocess.run(["cmake", "--build", build, "--target", "fumon_python_module"], check=True)
        return build

    def build_extension(self, ext: Extension) -> None:
        given = os.environ.get("FUMON_BUILD")  # a build folder with the module in it, absolute
        build = pathlib.Path(given) if given else self.build_module()
        made = pathlib.Path(self.get_ext_fullpath(ext.name))
        made.parent.mkdir(parents=True, exist_ok=True)
        built, = (build / "python" / "fumon").glob("_core.*.so")
        shutil.copyfile(built, made)
        for part, without in PARTS_WITHOUT.items():
            shutil.copytree(SOURCE / part, made.parent / "share" / part, dirs_exist_ok=True,
                            ignore=shutil.ignore_patterns(*without))
        shutil.copyfile(SOURCE / "LICENSE", made.parent / "share" / "LICENSE")


def version() -> str:
    text = (SOURCE / "CMakeLists.txt").read_text()
    return re.search(r"project\(fumon VERSION ([0-9.]+)", text)[1]


def readme() -> str:
    """The first paragraphs of the guide's page on Python."""
    page = (SOURCE / "assets" / "guide" / "python.md").read_text(encoding="utf-8")
    return page[:page.index("\n## ")].replace("# Python", "# fumon", 1)


def addresses() -> dict[str, str]:
    """Of whoever publishes fumon, which has no address itself."""
    page = os.environ.get("FUMON_HOMEPAGE")
    return {"Homepage": page} if page else {}


here = pathlib.Path(__file__).parent
os.chdir(here)
papers = {here / "LICENSE": SOURCE / "LICENSE", here / "copyright": SOURCE / "assets" / "copyright"}
try:
    for copy, paper in papers.items():  # setuptools takes none from above
        shutil.copyfile(paper, copy)
    setup(version=version(), long_description=readme(), long_description_content_type="text/markdown",
          project_urls=addresses(), ext_modules=[Extension("fumon._core", [])], cmdclass={"build_ext": BuildByCMake})
finally:
    for copy in papers:
        copy.unlink(missing_ok=True)
