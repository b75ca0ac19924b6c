import process from 'node:process';
import pc from 'picocolors';

export type Colors = ReturnType<typeof pc.createColors>;

/** No colours: for files, pipes and tests. */
export const PLAIN: Colors = pc.createColors(false);

/** Colours for a stream: used on a terminal, unless NO_COLOR is set or TERM is dumb, and always with FORCE_COLOR. */
export function colorsFor(stream: { readonly isTTY?: boolean }): Colors {
  const { NO_COLOR, FORCE_COLOR, TERM } = process.env;
  if (NO_COLOR) return PLAIN;
  return pc.createColors(FORCE_COLOR ? FORCE_COLOR !== '0' : stream.isTTY === true && TERM !== 'dumb');
}

/** The characters of a line of a terminal; null for files and pipes, which can have lines of any length. */
export function widthOf(stream: { readonly isTTY?: boolean; readonly columns?: number }): number | null {
  if (stream.isTTY !== true) return null;
  const asked = Number(process.env.COLUMNS);
  return Number.isInteger(asked) && asked > 0 ? asked : (stream.columns ?? null) || null;
}
