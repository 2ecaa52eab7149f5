"""Every example runs, prints what the manual says, and is short."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from support import SOURCE

EXAMPLES = sorted((SOURCE / "app/python/examples").glob("*.py"))
MANUAL = (SOURCE / "app/python/README.md").read_text()


class Examples(unittest.TestCase):
    def test_run(self):
        self.assertEqual(len(EXAMPLES), 5)
        for example in EXAMPLES:
            text = example.read_text()
            if "matplotlib" in text:
                try:
                    import matplotlib  # noqa: F401
                except ImportError:
                    continue
            with self.subTest(example.name), tempfile.TemporaryDirectory() as folder:
                done = subprocess.run([sys.executable, example], capture_output=True, text=True, cwd=folder)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertLessEqual(text.count("\n"), 20)
                # The manual has the program as it is, and behind it what it prints.
                self.assertIn(f"```python\n{text}```\n", MANUAL)
                if done.stdout:
                    self.assertIn(f"```text\n{done.stdout}```\n", MANUAL)
                made = {path.name for path in pathlib.Path(folder).iterdir()}
                self.assertEqual(made, set(re.findall(r"save(?:fig)?\(\"(.*?)\"\)", text)))


if __name__ == "__main__":
    unittest.main()
