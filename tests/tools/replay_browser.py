"""Opens replay pages in headless Chromium, as a user does, and prints what it finds as JSON lines.

    replay_browser.py load PAGE...                 console errors, requests and the time until the page is usable
    replay_browser.py ask PAGE SCRIPT...           the values of JavaScript expressions, awaited, in the page
    replay_browser.py picture PAGE PNG WIDTH HEIGHT THEME SCRIPT...   a picture after the scripts

Needs Debian's chromium, chromium-driver and python3-selenium.
"""

import json
import pathlib
import sys

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service


def start(width=1280, height=800):
    options = Options()
    options.binary_location = "/usr/bin/chromium"
    for argument in (
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-dev-shm-usage",
        "--disable-background-networking",
        "--hide-scrollbars",
        f"--window-size={width},{height}",
    ):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    browser.set_script_timeout(60)
    return browser


def evaluate(browser, script):
    """The awaited value of an expression; an error of the page is {"error": text}."""
    return browser.execute_async_script(
        "const done = arguments[arguments.length - 1];"
        f"(async () => {script})().then(done, (error) => done({{error: String(error)}}));"
    )


# When the page was usable, and the addresses that it asked for.
LOADED = """{
    await replay.ready;
    const usable = performance.now();
    await replay.whole;
    return { usable, requests: performance.getEntriesByType("resource").map((entry) => entry.name) };
}"""


def load(browser, page):
    browser.get(pathlib.Path(page).resolve().as_uri())
    for frame in browser.find_elements("tag name", "iframe"):  # of a page that contains a player
        browser.switch_to.frame(frame)
    loaded = evaluate(browser, LOADED)
    return {
        "page": page,
        "failure": loaded.get("error"),
        "console": [entry["message"] for entry in browser.get_log("browser")],
        "requests": loaded.get("requests", []),
        "usable_ms": loaded.get("usable"),
    }


def picture(browser, page, file, theme, scripts):
    load(browser, page)
    evaluate(browser, f"replay.player.setTheme('{theme}')")
    for script in scripts:
        print(json.dumps(evaluate(browser, script)), flush=True)
    evaluate(browser, "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(null))))")
    browser.save_screenshot(file)


def main(arguments):
    what, pages = arguments[0], arguments[1:]
    if what == "picture":
        browser = start(int(pages[2]), int(pages[3]))
        if int(pages[2]) < 500:
            browser.execute_cdp_cmd(
                "Emulation.setDeviceMetricsOverride",
                {"width": int(pages[2]), "height": int(pages[3]), "deviceScaleFactor": 2, "mobile": True},
            )
    else:
        browser = start()
    try:
        if what == "load":
            for page in pages:
                print(json.dumps(load(browser, page)), flush=True)
        elif what == "ask":
            load(browser, pages[0])
            for script in pages[1:]:
                print(json.dumps(evaluate(browser, script)), flush=True)
        elif what == "picture":
            picture(browser, pages[0], pages[1], pages[4], pages[5:])
        else:
            sys.exit(__doc__)
    finally:
        browser.quit()


if __name__ == "__main__":
    main(sys.argv[1:])
