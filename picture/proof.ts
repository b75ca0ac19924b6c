import type { Place } from '../schema/index.ts';
import type { Theme } from './theme.ts';
import { lineThrough, type View } from './view.ts';
import { num } from './xml.ts';

type Role = 'blocked' | 'reach' | 'range' | 'thing' | 'barrier' | 'stretch';

/**
 * The drawing of a proof, in px of the level. `blocked`: her centre cannot be inside; `range`: she is lost outside all of
 * these; `thing`: her box could touch the object from inside; `barrier`: she cannot cross it; `stretch`: she cannot leave it;
 * `reach`: squares through which she may come.
 */
export interface ProofOverlay {
  readonly discs: readonly (Place & { readonly radius: number; readonly role: Role })[];
  readonly lines: readonly { readonly points: readonly Place[]; readonly closed: boolean; readonly role: Role }[];
}

/** The most discs to draw; more of them say nothing. */
const MOST_DISCS = 2000;

/** Draws a proof over its level. */
export function drawProof(view: View, theme: Theme, { discs, lines }: ProofOverlay): string {
  const rings = discs.slice(0, MOST_DISCS).map(({ x, y, radius, role }) => {
    const circle = `<circle data-kind="proof-${role}" cx="${num(view.x(x))}" cy="${num(view.y(y))}" r="${num(radius * view.scale)}"`;
    return `${circle} ${discStyle(theme, role)}/>`;
  });
  const outline = ({ points, closed }: ProofOverlay['lines'][number]): string =>
    lineThrough(
      view,
      points.map(({ x, y }) => [x, y]),
      closed,
    );
  const squares = lines.filter(({ role }) => role === 'reach').map(outline);
  const reach = squares.length === 0 ? '' : `<path data-kind="proof-reach" d="${squares.join('')}" ${reachStyle(theme)}/>`;
  const paths = lines.map((line) => {
    const { role } = line;
    if (role === 'reach') return '';
    const d = outline(line);
    const color = role === 'barrier' ? theme.bad : theme.gun;
    return (
      `<path d="${d}" fill="none" stroke="${theme.halo}" stroke-width="8" stroke-opacity=".55" stroke-linejoin="round" stroke-linecap="round"/>` +
      `<path data-kind="proof-${role}" d="${d}" fill="none" stroke="${color}" stroke-width="3.4" stroke-linejoin="round" stroke-linecap="round"/>`
    );
  });
  return `<g data-kind="proof">${reach}${rings.join('')}${paths.join('')}</g>`;
}

const reachStyle = (theme: Theme): string => `fill="${theme.gun}" fill-opacity=".3"`;

function discStyle(theme: Theme, role: Role): string {
  switch (role) {
    case 'range':
      return `fill="${theme.range}" fill-opacity=".1" stroke="${theme.range}" stroke-width="1.6" stroke-dasharray="8 5"`;
    case 'thing':
      return `fill="${theme.good}" fill-opacity=".08" stroke="${theme.good}" stroke-width="1.6" stroke-dasharray="2 4" stroke-linecap="round"`;
    default:
      return `fill="${theme.bad}" fill-opacity=".16" stroke="${theme.bad}" stroke-width="1.4"`;
  }
}

const WORDS: Record<Role, string> = {
  blocked: 'what keeps her out',
  reach: 'everywhere she can go',
  range: 'outside these she is lost',
  thing: 'from here she would touch it',
  barrier: "can't be crossed",
  stretch: "can't be left",
};

/** The legend's entries for a proof. */
export function proofSigns(theme: Theme, { discs, lines }: ProofOverlay): { readonly label: string; readonly icon: string }[] {
  const roles = new Set<Role>([...lines, ...discs].map(({ role }) => role));
  return [...roles].map((role) => ({
    label: WORDS[role],
    icon: drawSign(theme, role),
  }));
}

function drawSign(theme: Theme, role: Role): string {
  if (role === 'reach') return `<rect x="-8" y="-8" width="16" height="16" ${reachStyle(theme)}/>`;
  if (role !== 'barrier' && role !== 'stretch') return `<circle r="8" ${discStyle(theme, role)}/>`;
  const color = role === 'barrier' ? theme.bad : theme.gun;
  return `<path d="M-9 3L-2-4L9 2" fill="none" stroke="${color}" stroke-width="3.2" stroke-linecap="round" stroke-linejoin="round"/>`;
}
