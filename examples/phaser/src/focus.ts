/** Directions of the arrow keys. */
export const STEPS: Readonly<Record<string, readonly [number, number] | undefined>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Moves the focus to the nearest control in a direction. */
export function moveFocus(root: HTMLElement, [dx, dy]: readonly [number, number]): void {
  const all = [...root.querySelectorAll<HTMLElement>('button, input:not(.unseen), textarea')].filter(
    (one) => one.offsetParent !== null || one.getClientRects().length > 0,
  );
  const from = document.activeElement;
  if (!(from instanceof HTMLElement) || !all.includes(from)) {
    all[0]?.focus();
    return;
  }
  const middle = (one: HTMLElement) => {
    const { left, top, width, height } = one.getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  };
  const [x, y] = middle(from);
  let best: HTMLElement | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (const one of all) {
    const [ox, oy] = middle(one);
    const along = (ox - x) * dx + (oy - y) * dy;
    const across = Math.abs((ox - x) * dy) + Math.abs((oy - y) * dx);
    if (one === from || along < 4) continue;
    const distance = along + 3 * across;
    if (distance < least) [best, least] = [one, distance];
  }
  best?.focus();
  best?.scrollIntoView({ block: 'nearest' });
}
