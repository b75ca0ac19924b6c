import type { Locator } from '../locate.ts';
import type { Finding, Problem } from '../problem.ts';

/** A map as a value in Tiled's JSON map format, whatever the format of the file. */
export type MapSource =
  | {
      readonly ok: true;
      readonly text: string;
      readonly value: unknown;
      readonly locator: Locator;
      readonly findings: readonly Finding[];
    }
  | { readonly ok: false; readonly problems: Problem[]; readonly text: string };
