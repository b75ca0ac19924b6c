import { Activity } from 'lucide-react';
import { type KeyboardEvent, type PointerEvent, type ReactNode, useEffect, useLayoutEffect, useRef, useState } from 'react';
import { mediaOf, useEditor, useMedia, useSession } from '../core/context/index.ts';
import { Button } from '../core/ui/index.ts';
import { useProblemCount } from '../features/index.ts';
import type { SidePanel } from './panels.tsx';

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

interface LayoutProps {
  /** From top to bottom. */
  readonly left: readonly [ReactNode, ReactNode];
  readonly canvas: ReactNode;
  readonly right: readonly [ReactNode, ReactNode];
  readonly timeline: ReactNode;
  /** The panels of both sides, shown one at a time where there is no room beside the canvas. */
  readonly panels: readonly SidePanel[];
}

function NarrowLayout({ canvas, timeline, panels }: LayoutProps) {
  const { session } = useEditor();
  const shown = useSession((state) => state.panels.phone);
  const show = (phone: string | null) => session.setState({ panels: { ...session.getState().panels, phone } });
  const all = [{ id: 'timeline', title: 'Timeline', icon: <Activity size={17} />, content: timeline }, ...panels];
  // a playtest needs all of a small screen
  const isPlaying = useSession((state) => state.mode === 'play');
  const panel = isPlaying ? undefined : all.find(({ id }) => id === shown);
  return (
    <div className={panel === undefined ? 'narrow' : 'narrow narrow--open'}>
      <main className="region region--canvas">{canvas}</main>
      {panel !== undefined && <section className={`region narrow__sheet narrow__sheet--${panel.id}`}>{panel.content}</section>}
      {!isPlaying && (
        <nav className="narrow__tabs" aria-label="Panels">
          {all.map(({ id, title, icon }) => (
            <Button key={id} hint={title} icon={icon} pressed={id === shown} onClick={() => show(id === shown ? null : id)}>
              {title}
            </Button>
          ))}
        </nav>
      )}
    </div>
  );
}

/** Two panels, one above the other. */
function Side({ parts: [upper, lower], ...own }: Pick<DividedProps, 'id' | 'parts' | 'size' | 'isLine'>) {
  const parts = [
    <div key="upper" className="region">
      {upper}
    </div>,
    <div key="lower" className="region">
      {lower}
    </div>,
  ] as const;
  return <Divided {...own} as="column" parts={parts} sized={1} least={80} rest="80px" line={LINE} />;
}

/** px of a panel that is collapsed to one line */
const LINE = 40;

/** initial height of the timeline in px, and the largest share of a low page that it takes */
const TIMELINE = { height: 230, share: 0.3 } as const;

/** The two sides, the canvas and the timeline, with dividers that can be dragged or moved with keys. */
function WideLayout({ left, canvas, right, timeline }: LayoutProps) {
  const nothingWrong = useProblemCount() === 0;
  const [timelineHeight] = useState(() => Math.round(Math.min(TIMELINE.height, TIMELINE.share * window.innerHeight)));
  const leftSide = (
    <aside className="region" aria-label="Levels and objects">
      <Side id="left-side" parts={left} size="55%" />
    </aside>
  );
  const rightSide = (
    <aside className="region" aria-label="Inspector and problems">
      <Side id="right-side" parts={right} size="30%" isLine={nothingWrong} />
    </aside>
  );
  const middle = (
    <Divided
      id="middle"
      as="column"
      parts={[
        <main key="canvas" className="region region--canvas">
          {canvas}
        </main>,
        <section key="timeline" className="region" aria-label="Timeline">
          {timeline}
        </section>,
      ]}
      sized={1}
      size={`${timelineHeight}px`}
      least={120}
      most={420}
      rest="55%"
    />
  );
  const others = (
    <Divided id="right" as="row" parts={[middle, rightSide]} sized={1} size="300px" least={220} most={520} rest="320px" />
  );
  // beside the left side there must be room for the canvas and the right one
  return <Divided id="left" as="row" parts={[leftSide, others]} sized={0} size="250px" least={180} most={420} rest="541px" />;
}

/** All panels where there is room, else one at a time; the canvas always stays visible. */
export function Layout(props: LayoutProps) {
  return useRoom() === 'wide' ? <WideLayout {...props} /> : <NarrowLayout {...props} />;
}

/**
 * What the page has room for: panels on both sides of the canvas, or one panel at a time, beside the canvas on low pages and
 * below it on narrow ones. Zoom shrinks a page as well: 1440 x 900 at 200 % is 720 x 450.
 */
type Room = 'wide' | 'beside' | 'below';

/** Below this size, too little of the canvas is left between two sides. */
const WIDE = mediaOf('(min-width: 880px) and (min-height: 520px)');
/** From this width on, the canvas keeps 320 px beside a panel. */
const BESIDE = mediaOf('(min-width: 600px) and (orientation: landscape)');

/** The room of the page; the component re-renders when it changes. */
export function useRoom(): Room {
  const [isWide, isBeside] = [useMedia(WIDE), useMedia(BESIDE)];
  return isWide ? 'wide' : isBeside ? 'beside' : 'below';
}
