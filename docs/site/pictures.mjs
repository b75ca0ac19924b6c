import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';

/**
 * Finds the pictures of the pages that have two versions, in dark and in light colours, and reads the light ones. Screenshots lie
 * side by side; pictures of levels are drawn by the commands that the pages name.
 * @param {string} project folder of the project, which has been built
 * @param {string[]} pages their paths in the project
 * @returns {Map<string, Buffer>} the light version by the path of the dark one
 */
export function lightVersions(project, pages) {
  const light = new Map();
  for (const page of pages) {
    const text = readFileSync(join(project, page), 'utf8');
    for (const [, level, picture, rest] of text.matchAll(/npx gq render (\S+) -o (docs\/\S+\.svg)((?: --[a-z-]+| \w+)*)/g)) {
      const words = ['render', level, '-o', '-', ...rest.trim().split(/\s+/).filter(Boolean), '--theme', 'light'];
      const gq = join(project, 'dist/gq/main.js');
      light.set(picture, execFileSync(process.execPath, [gq, ...words], { cwd: project, stdio: ['ignore', 'pipe', 'inherit'] }));
    }
    for (const [, name] of text.matchAll(/([\w-]+)-dark\.png/g)) {
      const file = `docs/${name}-light.png`;
      if (existsSync(join(project, file))) light.set(`docs/${name}-dark.png`, readFileSync(join(project, file)));
    }
  }
  return light;
}
