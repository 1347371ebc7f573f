// schemas/ in ajv, which editors and others use: both are sound, take every file of ours, and refuse
// what is wrong.

import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { check, root } from "./browser.mjs";

const require = createRequire(join(root, "build/web-tests/package.json"));
const Ajv = require("ajv/dist/2020").default;

const json = (...path) => JSON.parse(readFileSync(join(root, ...path)));
const files = (folder) => readdirSync(join(root, folder)).filter((name) => name.endsWith(".json"))
  .map((name) => [folder, name]);

const ajv = new Ajv({ strict: true, allErrors: true });
const scene = ajv.compile(json("schemas/scene.schema.json"));
const replay = ajv.compile(json("schemas/replay.schema.json"));

let valid = 0;
const take = (validate, value, what) => {
  check(validate(value), `${what}: ${ajv.errorsText(validate.errors)}`);
  ++valid;
};
const beside = /(\.proof|^pack)\.json$/;
const shipped = files("levels").filter((file) => !beside.test(file.at(-1)));
for (const file of [...files("scenes"), ...shipped]) take(scene, json(...file), file);
for (const file of files("tests/replays")) {
  const value = json(...file);
  if (value.physics === 1 && value["angry-balls-replay"] === 1) take(replay, value, file);
}
check(valid > 15, `only ${valid} files`);
const level = json("levels/01-first-steps.json");
take(scene, { ...level, $schema: "x", author: "a", licence: "b", description: "c" }, "texts");
for (const wrong of [{ ...level, wind: 1 }, { ...level, author: 3 }, { ...level, width: -1 },
  { ...level, description: "x".repeat(2001) }, { ...level, carom: 2 }, {}, []])
  check(!scene(wrong), `taken: ${JSON.stringify(wrong).slice(0, 60)}`);
check(!replay({ ...json(...files("tests/replays")[0]), level: 3 }), "a replay with a level 3");
console.log(`${valid} files are valid`);
