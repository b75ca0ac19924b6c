import { Activity } from 'lucide-react';
import { type ReactNode, useState } from 'react';
import { mediaOf, useEditor, useMedia, useSession } from '../core/context/index.ts';
import { Button } from '../core/ui/index.ts';
import { useProblemCount } from '../features/index.ts';
import { Divided, type DividedProps } from './Divided.tsx';
import type { SidePanel } from './panels.tsx';

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
