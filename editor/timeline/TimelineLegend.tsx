import { CircleQuestionMark, Flag, X } from 'lucide-react';
import { Popover } from 'radix-ui';
import type { ReactNode } from 'react';
import { useTouch } from '../core/context/index.ts';
import { NEAR } from '../core/proof/index.ts';
import { Button } from '../core/ui/index.ts';
import type { LegendEntry, TimelinePart } from './part.ts';

/** A sign of the legend as it is written on the timeline: `A2`. */
const markedAs = (text: string): ReactNode => <span className="legend__mark">{text}</span>;

/** A sign of the legend that is drawn as what it explains. @param name of its look: `legend__look--NAME` in a style sheet */
export const looksLike = (name: string): ReactNode => <span className={`legend__look legend__look--${name}`} />;

interface TimelineLegendProps {
  /** What features of the page show in the timeline, and what it means. */
  readonly parts: readonly TimelinePart[];
  readonly isOpen: boolean;
  readonly onOpen: (isOpen: boolean) => void;
}

const BARS: readonly LegendEntry[] = [
  [looksLike('hold'), 'The gun is held. The number is how long, in ticks of 1/60 s.'],
  [looksLike('slack'), 'Slack: how far this press or release alone may slip while the run still completes the level.'],
  [looksLike('missed'), 'Not reached: the run ends before or during this hold.'],
  [looksLike('after'), 'After the end of a run that fails.'],
];

const MARKS: readonly LegendEntry[] = [
  [markedAs('A2'), 'Asteroid 2 becomes the target.'],
  [markedAs('◆1'), 'Mineral 1 is collected.'],
  [markedAs('R1 /R1'), 'She enters repulsor 1; she leaves it.'],
  [markedAs('E1! E1z'), 'Alien 1 wakes up; it falls asleep.'],
  [markedAs('✺'), 'Two aliens explode.'],
  [markedAs('● ✕'), 'She reaches the black hole; she collides or is lost.'],
  [looksLike('speed'), 'Her speed.'],
  [looksLike('gap'), 'Her distance to the nearest hazard.'],
];

const NOTES: readonly LegendEntry[] = [
  [<Flag key="flag" size={12} />, 'A note: click it to read and change it.'],
  [looksLike('near'), `Near miss: she passes a hazard at less than ${NEAR} px.`],
];

/** What the bars, hatches, marks and lines of the timeline mean, and how to edit a hold. */
export function TimelineLegend({ parts, isOpen, onOpen }: TimelineLegendProps) {
  const touch = useTouch();
  const of = (what: 'bars' | 'graphs') => parts.flatMap(({ legend }) => legend?.[what] ?? []);
  const entries = [...BARS, ...of('bars'), ...MARKS, ...of('graphs'), ...NOTES];
  return (
    <Popover.Root open={isOpen} onOpenChange={onOpen}>
      <Popover.Trigger asChild>
        <Button hint="Timeline legend" icon={<CircleQuestionMark size={15} />} />
      </Popover.Trigger>
      <Popover.Portal>
        <Popover.Content
          className="legend"
          side="top"
          sideOffset={6}
          collisionPadding={8}
          aria-label="Timeline legend"
          // On the first button, the focus would open a tooltip, and Esc would close that instead of the legend.
          onOpenAutoFocus={(event) => {
            event.preventDefault();
            if (event.target instanceof HTMLElement) event.target.focus();
          }}
        >
          <div className="legend__head">
            <h2 className="legend__title">Timeline legend</h2>
            <Popover.Close asChild>
              <Button hint="Close" icon={<X size={15} />} />
            </Popover.Close>
          </div>
          <ul className="legend__list">
            {entries.map(([sign, words]) => (
              <li key={words} className="legend__one">
                <span className="legend__sign" aria-hidden>
                  {sign}
                </span>
                <span>{words}</span>
              </li>
            ))}
          </ul>
          <p className="legend__how">
            Drag the middle of a hold to move it, an end to stretch it, or the empty lane to add one.
            {touch
              ? ' Double-tap a hold to split it.'
              : ' Hold Alt to move everything after it as well. Double-click a hold to split it.'}
          </p>
        </Popover.Content>
      </Popover.Portal>
    </Popover.Root>
  );
}
