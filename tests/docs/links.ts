import { existsSync, readFileSync, statSync } from 'node:fs';
import { join, posix } from 'node:path';
import { type Page, PROJECT } from './page.ts';

const withoutCode = (text: string): string => text.replace(/`[^`\n]*`/g, (code) => ' '.repeat(code.length));

/** The anchors of a page's headings, made as GitHub makes them. */
export function anchorsOf(text: string): Set<string> {
  const anchors = new Set<string>();
  let isCode = false;
  for (const line of text.split('\n')) {
    if (/^\s*```/.test(line)) isCode = !isCode;
    const heading = isCode ? null : /^#{1,6}\s+(.*)$/.exec(line);
    if (heading === null) continue;
    const words = heading[1].replace(/\[([^\]]*)\]\([^)]*\)/g, '$1').replace(/[`*]/g, '');
    const slug = words
      .trim()
      .toLowerCase()
      .replace(/[^\p{L}\p{N}\s_-]/gu, '')
      .replace(/\s/g, '-');
    let anchor = slug;
    for (let n = 1; anchors.has(anchor); n++) anchor = `${slug}-${n}`;
    anchors.add(anchor);
  }
  return anchors;
}

/** Links and pictures of a page that lead nowhere. */
export function brokenLinks({ path, prose }: Page): string[] {
  const broken: string[] = [];
  for (const [, isPicture, words, target] of withoutCode(prose).matchAll(/(!?)\[([^\]]*)\]\(([^)\s]+)\)/g)) {
    if (isPicture && words.trim() === '') broken.push(`${target}: a picture needs words for those who do not see it`);
    if (/^(https?|mailto):/.test(target)) continue;
    const [file, anchor] = target.split('#');
    const found = file === '' ? path : posix.normalize(posix.join(posix.dirname(path), file));
    if (!existsSync(join(PROJECT, found))) broken.push(`${target}: no such file`);
    else if (anchor !== undefined && !found.endsWith('.md')) broken.push(`${target}: anchors are for pages`);
    else if (anchor !== undefined && !anchorsOf(readFileSync(join(PROJECT, found), 'utf8')).has(anchor)) {
      broken.push(`${target}: no such heading`);
    }
  }
  return broken;
}

const ROOMS = ['bench', 'check', 'cli', 'docs', 'editor', 'engine', 'levels', 'picture', 'schema', 'solver', 'tests'];

const isFile = (path: string): boolean => statSync(join(PROJECT, path), { throwIfNoEntry: false })?.isFile() === true;

/** Files of the project that a page names in `code` and that are not there. */
export function missingFiles({ path: page, prose }: Page): string[] {
  return [...prose.matchAll(/`([a-z]+\/[\w./-]+)`/g)]
    .map(([, path]) => path)
    .filter((path) => ROOMS.includes(path.split('/')[0]) && /\.\w+$/.test(path))
    .filter((path) => ![path, posix.join(posix.dirname(page), path)].some(isFile));
}
