// Builds the documents as a static site with search into dist/docs: node docs/site/build.mjs. DOCS_BASE is its path on the server.
import { cpSync, existsSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'vitepress';
import { PROJECT, STAGE, stagePages } from './stage.mjs';

stagePages();
await build(join(PROJECT, 'docs/site'));
rmSync(STAGE, { recursive: true, force: true });

// the reference of the library, where it has been made; .vitepress/config.mjs links to it then
const api = join(PROJECT, 'dist/api');
if (existsSync(api)) cpSync(api, join(PROJECT, 'dist/docs/api'), { recursive: true });
