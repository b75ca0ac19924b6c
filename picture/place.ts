import type { View } from './view.ts';
import { num } from './xml.ts';

/** Moves a drawing, which is centred on the origin in px of the level, to its place in the level. */
export function place(
  view: View,
  kind: string,
  index: number,
  at: { readonly x: number; readonly y: number },
  drawing: string,
): string {
  const scale = Number(view.scale.toFixed(6));
  return (
    `<g data-kind="${kind}" data-index="${index}" transform="translate(${num(view.x(at.x))} ${num(view.y(at.y))}) ` +
    `scale(${scale})">${drawing}</g>`
  );
}
