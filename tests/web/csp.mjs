// The content security policy: the page runs under it without a complaint, and what somebody managed to
// put into it would not run.

import { check, withPage } from "./browser.mjs";

await withPage({ width: 800, height: 600 }, async (game) => {
  await game.open();
  await game.press("Enter");
  await game.waitFor("Player 1 aims");
  check(game.errors.length === 0, `complaints: ${game.errors.join("; ")}`);

  const blocked = await game.page.evaluate(async () => {
    const found = [];
    document.addEventListener("securitypolicyviolation", (event) =>
      found.push(event.effectiveDirective));
    const add = (name, set) => document.body.append(Object.assign(document.createElement(name), set));
    add("script", { textContent: "window.intruder = true;" });
    add("script", { src: "data:text/javascript,window.intruder = true;" });
    add("style", { textContent: "#canvas { display: none; }" });
    add("img", { src: "http://127.0.0.1:9/image.png" });
    add("iframe", { src: "http://127.0.0.1:9/" });
    document.body.setAttribute("onclick", "window.intruder = true;");
    document.body.click();
    await fetch("http://127.0.0.1:9/").catch(() => {});
    try { setTimeout("window.intruder = true;", 0); } catch { /* that is what it is to do */ }
    await new Promise((resolve) => setTimeout(resolve, 500));
    return { found: [...new Set(found)].sort().join(), intruder: window.intruder ?? false,
      canvas: getComputedStyle(document.getElementById("canvas")).display };
  });
  check(!blocked.intruder, "a script from elsewhere has run");
  check(blocked.canvas === "block", "a style from elsewhere counts");
  const expected = "connect-src,frame-src,img-src,script-src,script-src-attr,script-src-elem,style-src-elem";
  check(blocked.found === expected, `blocked: ${blocked.found}`);
  game.errors.length = 0; // those
});
