"""Debian's Chromium without a display, for pages of the disk: by Selenium and chromedriver."""

import shutil
import tempfile
import time

FLAGS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--hide-scrollbars"]
SURFACES_IN_SOFTWARE = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]


def missing():
    """What is not installed, in words; empty where all is there."""
    lacking = [name for name in ("chromium", "chromedriver") if not shutil.which(name)]
    try:
        import selenium.webdriver  # noqa: F401
    except ImportError:
        lacking.append("python3-selenium")
    return ", ".join(lacking)


class Browser:
    """A browser with a profile of its own, which goes with it."""

    def __init__(self, width=1280, height=800, dark=False, webgl=True, scale=1):
        from selenium import webdriver
        from selenium.webdriver.chrome.options import Options
        from selenium.webdriver.chrome.service import Service
        self.profile = tempfile.TemporaryDirectory()
        options = Options()
        options.binary_location = shutil.which("chromium")
        for flag in FLAGS + (SURFACES_IN_SOFTWARE if webgl else ["--disable-3d-apis"]) + ["--user-data-dir=" + self.profile.name]:
            options.add_argument(flag)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=False)
        self.command("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
                                                              {"name": "prefers-reduced-motion", "value": "reduce"}])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()
        self.profile.cleanup()

    def command(self, name, **parameters):
        return self.driver.execute_cdp_cmd(name, parameters)

    def run(self, script, *arguments):
        """What the script returns."""
        return self.driver.execute_script(script, *arguments)

    def open(self, page):
        """Opens a report and waits until it is drawn. Returns its state, "true" or "failed", and the seconds."""
        begin = time.monotonic()
        self.driver.get("file://" + str(page))
        while not (state := self.run("return document.documentElement.dataset.ready")):
            if time.monotonic() - begin > 60:
                raise TimeoutError(f"{page}: not ready after a minute")
            time.sleep(0.02)
        self.settle()
        return state, time.monotonic() - begin

    def settle(self):
        """Waits for two frames, in the second of which everything has been drawn."""
        self.driver.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done()));")

    def set(self, name, value):
        """Moves a slider or takes a choice, as a user does."""
        self.run("""const e = document.getElementById(arguments[0]);
                    if (e.type === "checkbox") { if (e.checked !== arguments[1]) e.click(); return; }
                    const choices = e.tagName === "SELECT" ? [...e.options].map((o) => o.value) : null;
                    if (choices && !choices.includes(arguments[1])) throw new Error(`${arguments[0]}: ${arguments[1]} is none of ${choices.join(", ")}`);
                    e.value = arguments[1];
                    e.dispatchEvent(new Event(e.tagName === "SELECT" ? "change" : "input", { bubbles: true }));""", name, value)
        self.settle()

    def picture(self, name):
        """The pixels of an element as PNG, by its id."""
        from selenium.webdriver.common.by import By
        return self.driver.find_element(By.ID, name).screenshot_as_png

    def errors(self):
        """What the page has complained of since the last call."""
        return [entry["message"] for entry in self.driver.get_log("browser") if "GPU stall due to ReadPixels" not in entry["message"]]
