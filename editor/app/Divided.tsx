import { type KeyboardEvent, type PointerEvent, type ReactNode, useEffect, useLayoutEffect, useRef, useState } from 'react';

export interface DividedProps {
  readonly id: string;
  /** `row`: beside each other. `column`: one above the other. */
  readonly as: 'row' | 'column';
  readonly parts: readonly [ReactNode, ReactNode];
  /** Which part has a size of its own; the other one has the rest. */
  readonly sized: 0 | 1;
  /** That size at first: px stay when the page changes, % are a share of it. */
  readonly size: `${number}px` | `${number}%`;
  /** The least and the largest size, px. */
  readonly least: number;
  readonly most?: number;
  /** The least size of the rest, as CSS says it. */
  readonly rest: string;
  /** px of the sized part when it is collapsed to one line; left out: it can't be. */
  readonly line?: number;
  /** Whether it is to be collapsed; people may differ until this changes. */
  readonly isLine?: boolean;
}

/** Part of the whole that an arrow key moves a divider by. */
const STEP = 0.05;

/** Two parts with a divider that can be dragged, moved with keys, and put back by a double click. */
export function Divided({ id, as, parts, sized, size, least, most, rest, line, isLine = false }: DividedProps) {
  const frame = useRef<HTMLDivElement>(null);
  const divider = useRef<HTMLDivElement>(null);
  const grabbed = useRef<{ readonly at: number; readonly from: number } | null>(null);
  const [basis, setBasis] = useState<string>(size);
  const [isCollapsed, setCollapsed] = useState(isLine);
  const wasLine = useRef(isLine);
  useEffect(() => {
    if (wasLine.current !== isLine) setCollapsed(isLine);
    wasLine.current = isLine;
  }, [isLine]);

  const [length, place] = as === 'row' ? (['width', 'clientX'] as const) : (['height', 'clientY'] as const);
  const whole = () => frame.current?.getBoundingClientRect()[length] ?? 0;
  const present = () => frame.current?.children[2 * sized].getBoundingClientRect()[length] ?? 0;
  const resize = (px: number) => {
    const isTooLow = line !== undefined && px < (isCollapsed ? line + 1 : (line + least) / 2);
    setCollapsed(isTooLow);
    if (isTooLow) return;
    const fit = Math.min(most ?? Number.POSITIVE_INFINITY, whole(), Math.max(least, px));
    setBasis(size.endsWith('%') ? `${(100 * fit) / whole()}%` : `${fit}px`);
  };

  // what a screen reader says of the divider: the share of the part before it, %
  useLayoutEffect(() => {
    const share = Math.round((100 * present()) / Math.max(1, whole()));
    divider.current?.setAttribute('aria-valuenow', String(sized === 0 ? share : 100 - share));
  });

  const onKeyDown = (event: KeyboardEvent) => {
    const grow = sized === 0 ? 1 : -1;
    const [back, on] = as === 'row' ? ['ArrowLeft', 'ArrowRight'] : ['ArrowUp', 'ArrowDown'];
    if (event.key === back) resize(present() - grow * STEP * whole());
    else if (event.key === on) resize(present() + grow * STEP * whole());
    else if (event.key === 'Home') resize(grow > 0 ? 0 : whole());
    else if (event.key === 'End') resize(grow > 0 ? whole() : 0);
    else if (event.key === 'F6') focusNext(event.currentTarget, event.shiftKey);
    else return;
    event.preventDefault();
  };
  const onPointerDown = (event: PointerEvent) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    grabbed.current = { at: event[place], from: present() };
  };
  const onPointerMove = (event: PointerEvent) => {
    if (grabbed.current === null) return;
    const moved = event[place] - grabbed.current.at;
    if (moved !== 0) resize(grabbed.current.from + (sized === 0 ? moved : -moved));
  };
  const onRelease = () => {
    // the rest may have left it less than was asked for
    if (grabbed.current !== null && !isCollapsed) resize(present());
    grabbed.current = null;
  };
  const putBack = () => {
    setCollapsed(false);
    setBasis(size);
  };

  const own = isCollapsed
    ? { flex: `0 0 ${line}px` }
    : { flex: `0 1 ${basis}`, [as === 'row' ? 'minWidth' : 'minHeight']: least, [as === 'row' ? 'maxWidth' : 'maxHeight']: most };
  const other = { flex: '1 1 0', [as === 'row' ? 'minWidth' : 'minHeight']: rest };
  return (
    <div ref={frame} className={`divided divided--${as}`}>
      <div id={`${id}-first`} className="divided__part" style={sized === 0 ? own : other}>
        {parts[0]}
      </div>
      {/* biome-ignore lint/a11y/useSemanticElements: it moves, which a rule does not */}
      <div
        ref={divider}
        role="separator"
        tabIndex={0}
        className="divider"
        aria-orientation={as === 'row' ? 'vertical' : 'horizontal'}
        aria-controls={`${id}-first`}
        aria-valuenow={50}
        aria-valuemin={0}
        aria-valuemax={100}
        onKeyDown={onKeyDown}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={onRelease}
        onPointerCancel={onRelease}
        onDoubleClick={putBack}
      />
      <div id={`${id}-second`} className="divided__part" style={sized === 1 ? own : other}>
        {parts[1]}
      </div>
    </div>
  );
}

/** Moves the focus to the next divider of the page, and around. */
function focusNext(divider: Element, isBack: boolean): void {
  const all = [...document.querySelectorAll<HTMLElement>('.divider')];
  all.at((all.indexOf(divider as HTMLElement) + (isBack ? -1 : 1)) % all.length)?.focus();
}
