// Builds the documents as a static site with search into dist/docs: node docs/site/build.mjs, after npm run build and npm run reference.
// DOCS_BASE is the path of the site on its server, such as /gravity-quest-toolkit/; without it, the site is at the root.
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { build } from 'vitepress';
import { checkSite } from './check-site.mjs';
import { BASE, PROJECT, SITE, STAGE, stagePages } from './stage.mjs';

stagePages();
await build(join(PROJECT, 'docs/site'));
rmSync(STAGE, { recursive: true, force: true });

const { pages, links, problems } = checkSite(SITE, BASE);
for (const problem of problems) console.error(problem);
if (problems.length > 0) process.exit(1);
console.log(`dist/docs: ${pages} pages, ${links} links and pictures, none broken`);
