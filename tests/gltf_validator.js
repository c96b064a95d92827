// Validates glTF files with Khronos' validator: paths as JSON on stdin, reports as JSON on stdout.
"use strict";
const fs = require("fs");
const path = require("path");
const { validateBytes } = require(process.argv[2]);

async function report(file) {
  const folder = path.dirname(file);
  return validateBytes(new Uint8Array(fs.readFileSync(file)), {
    uri: path.basename(file),
    maxIssues: 0,
    externalResourceFunction: (uri) =>
      fs.promises
        .readFile(path.join(folder, decodeURIComponent(uri)))
        .then((data) => new Uint8Array(data)),
  });
}

(async () => {
  const files = JSON.parse(fs.readFileSync(0, "utf8"));
  const reports = [];
  for (const file of files) {
    reports.push(await report(file).catch((error) => ({ failure: String(error) })));
  }
  process.stdout.write(JSON.stringify(reports));
})();
