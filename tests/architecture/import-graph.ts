import { posix } from 'node:path';
import { importsOf } from './inspect-source.ts';

/** A file of the project. */
export interface Source {
  /** From the project's root, with slashes: `engine/hash.ts`. */
  readonly path: string;
  readonly text: string;
}

/** Of each file, the files of the project it imports, in their order. Types count: who needs to know a shape stands on it. */
export type ImportGraph = ReadonlyMap<string, readonly string[]>;

export function importGraph(sources: readonly Source[]): ImportGraph {
  const known = new Set(sources.map(({ path }) => path));
  const targetsOf = ({ path, text }: Source): string[] =>
    importsOf(path, text).flatMap((specifier) => {
      if (!specifier?.startsWith('.')) return [];
      const target = posix.join(posix.dirname(path), specifier.replace(/\?.*$/, ''));
      // the compiler finds a.ts under the name a.js, too
      const found = [target, target.replace(/\.js(x?)$/, '.ts$1')].find((candidate) => known.has(candidate));
      return found === undefined ? [] : [found];
    });
  return new Map(sources.map((source) => [source.path, [...new Set(targetsOf(source))]]));
}

/**
 * Circles of imports, each as the whole way around: `a.ts -> b.ts -> a.ts`. Of the many ways around a knot of files it tells the shortest through each of them.
 */
export function circlesIn(graph: ImportGraph): string[] {
  const found = new Map<string, string>();
  const knots = knotsOf(graph);
  for (const path of knots.keys()) {
    const circle = shortestCircle(knots, path);
    if (circle === null) continue;
    const first = circle.indexOf([...circle].sort()[0]);
    const around = [...circle.slice(first), ...circle.slice(0, first), circle[first]].join(' -> ');
    found.set(around, around);
  }
  return [...found.keys()].sort();
}

/** The files that are left when those without an import that is left are taken away, again and again: those of circles, and those above them. */
function knotsOf(graph: ImportGraph): ImportGraph {
  let left = graph;
  for (let before = Number.POSITIVE_INFINITY; left.size < before; ) {
    before = left.size;
    const kept = left;
    left = new Map([...kept].filter(([, targets]) => targets.some((target) => kept.has(target))));
  }
  return left;
}

/** The shortest way by imports from a file back to it, without the return; null where there is none. Breadth first. */
function shortestCircle(graph: ImportGraph, start: string): string[] | null {
  const cameFrom = new Map<string, string>();
  const waiting = [start];
  for (let path = waiting.shift(); path !== undefined; path = waiting.shift()) {
    for (const target of graph.get(path) ?? []) {
      if (target === start) {
        const circle = [path];
        while (circle[0] !== start) circle.unshift(cameFrom.get(circle[0])!);
        return circle;
      }
      if (cameFrom.has(target)) continue;
      cameFrom.set(target, path);
      waiting.push(target);
    }
  }
  return null;
}

/**
 * Imports within a room that pass by a folder's face. A file may import the files of its own folder and of the folders around it; of any other folder
 * only `index.ts`, and where one lies in another that has an `index.ts`, only the outer one. `editor/features/` is a list of folders that know each
 * other as neighbours do.
 */
export function passedFaces(graph: ImportGraph): string[] {
  const roomOf = (path: string) => path.split('/')[0];
  return [...graph].flatMap(([path, targets]) =>
    targets
      .filter((target) => roomOf(target) === roomOf(path) && !isOnTheList(path, target))
      .flatMap((target) => {
        const face = faceBetween(graph, path, target);
        return face === null || face === target ? [] : [`${path} -> ${target}: passes by ${face}`];
      }),
  );
}

/** The list of features of the page knows each by its record. */
const isOnTheList = (path: string, target: string): boolean =>
  path === 'editor/features/index.ts' && /^editor\/features\/[a-z]+\/feature\.tsx$/.test(target);

/** The `index.ts` by which a file knows another; null where it needs none. It is named also where it is missing. */
function faceBetween(graph: ImportGraph, path: string, target: string): string | null {
  const parts = posix.dirname(target).split('/');
  const inside = parts.map((_, i) => parts.slice(0, i + 1).join('/')).filter((folder) => !path.startsWith(`${folder}/`));
  if (inside.length === 0) return null;
  const outermost = inside.find((folder) => graph.has(`${folder}/index.ts`));
  return `${outermost ?? inside[inside.length - 1]}/index.ts`;
}
