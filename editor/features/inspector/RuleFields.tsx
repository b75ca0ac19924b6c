import { RotateCcw } from 'lucide-react';
import { type KeyboardEvent, memo, type PointerEvent, useCallback, useEffect, useId, useRef } from 'react';
import { type GameRule, type LevelFile, RULES } from '../../../schema/index.ts';
import { useEditor, useFolderTerms, useLevel, useSession } from '../../core/context/index.ts';
import { type Gesture, type Recipe, setRule } from '../../core/document/index.ts';
import { problemsInWords } from '../../core/files/index.ts';
import { Section } from '../../core/panel/index.ts';
import { Button, NumberField } from '../../core/ui/index.ts';
import { originOf, positionOf, type RuleValue, ruleLabel, ruleValues, SLIDER_END, stepOf, valueAt, within } from './index.ts';

/** The rules of the level: its own, those of its folder, and the game's defaults. */
export function RuleFields({ file }: { readonly file: LevelFile }) {
  const { commands, session } = useEditor();
  const folder = useFolderTerms();
  const rules = ruleValues(file, folder);
  const asked = useSession((state) => state.askedRule);
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (asked === null) return;
    session.setState({ askedRule: null });
    const row = list.current?.querySelector(`[data-rule="${asked}"]`);
    row?.scrollIntoView({ block: 'center' });
    row?.querySelector<HTMLInputElement>('input[type="range"]')?.focus({ preventScroll: true });
  }, [asked, session]);
  useEffect(() => {
    const panel = list.current?.closest('.panel__body');
    if (panel == null) return;
    // A rule that breaks the run opens the list of problems, which must not cover the focused slider.
    const observer = new ResizeObserver(() => {
      const { activeElement } = panel.ownerDocument;
      if (list.current?.contains(activeElement)) activeElement?.closest('.rule')?.scrollIntoView({ block: 'nearest' });
    });
    observer.observe(panel);
    return () => observer.disconnect();
  }, []);
  const areSome = rules.some(({ isOwn }) => isOwn);
  return (
    <Section
      title="Rules"
      aside={
        areSome && (
          <Button
            hint={`Reset to ${folder.file === null ? "the game's defaults" : `the rules of ${folder.file} and the game's defaults`}`}
            icon={<RotateCcw size={13} />}
            onClick={() => commands.run('rules.reset')}
          >
            Reset all
          </Button>
        )
      }
    >
      {folder.problems.length > 0 && (
        <p className="tone--bad">
          {problemsInWords(folder.file ?? 'gq.config.json', folder.problems)} Its previous rules stay in effect until it is fixed.
        </p>
      )}
      <div ref={list} className="rules">
        {rules.map((rule) => (
          <RuleRow key={rule.name} {...rule} />
        ))}
      </div>
    </Section>
  );
}

/** A rule of the level: a slider, a number field and a reset button. */
const RuleRow = memo(function RuleRow({ name, value, isOwn, fallback, from }: RuleValue) {
  const { document } = useLevel();
  const id = useId();
  const rule = RULES[name];
  const label = ruleLabel(name);
  const step = `Set ${label} of the level`;
  const origin = originOf({ name, value, isOwn, fallback, from });
  // A value that equals the fallback is not written.
  const recipe = useCallback((next: number) => setRule(name, next === fallback ? undefined : next), [name, fallback]);
  return (
    <fieldset className={isOwn ? 'rule rule--own' : 'rule'} aria-label={label} data-rule={name}>
      <div className={isOwn ? 'row' : 'row row--default'}>
        <NumberField
          label={label}
          value={value}
          min={rule.least}
          max={rule.most}
          step={stepOf(rule)}
          unit={rule.unit}
          about={rule.about}
          onChange={(next, gesture) => void document.change(step, recipe(next), gesture === null ? {} : { gesture })}
          onGestureEnd={document.seal}
        />
        <span className="row__end">
          <span className="row__unit">{rule.unit}</span>
          {isOwn && (
            <Button
              hint={`Reset to ${fallback}, ${from === null ? "the game's default" : `from ${from}`}`}
              icon={<RotateCcw size={13} />}
              className="row__reset"
              aria-label={`Reset ${label}`}
              onClick={() => void document.change(`Reset ${label} of the level`, setRule(name, undefined))}
            />
          )}
        </span>
      </div>
      <div className="rule__range">
        <span className="numbers">{rule.least}</span>
        <RuleSlider {...{ rule, label, value, step, recipe }} describedBy={`${id}-about ${id}-origin`} />
        <span className="numbers">{rule.most}</span>
      </div>
      <p id={`${id}-about`} className="part__note">
        {rule.about}
      </p>
      <p id={`${id}-origin`} className="rule__origin" hidden={origin === null}>
        {origin}
      </p>
    </fieldset>
  );
});

/** how many steps a key moves the slider */
const KEYS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 10,
  PageDown: -10,
};

interface RuleSliderProps {
  readonly rule: GameRule;
  readonly label: string;
  readonly value: number;
  /** The label of the step in the history. */
  readonly step: string;
  /** Ids of the elements that describe it. */
  readonly describedBy: string;
  readonly recipe: (value: number) => Recipe;
}

/** The slider of a rule: the level follows while it is dragged, a drag is one step of the history, and Esc undoes it. */
function RuleSlider({ rule, label, value, step, describedBy, recipe }: RuleSliderProps) {
  const { document } = useLevel();
  const id = useId();
  const drag = useRef<{ readonly gesture: Gesture; readonly stop: () => void } | null>(null);
  const end = (how: 'commit' | 'cancel') => {
    drag.current?.gesture[how]();
    drag.current?.stop();
    drag.current = null;
  };
  // A drag in progress when the slider is unmounted is kept.
  useEffect(
    () => () => {
      drag.current?.gesture.commit();
      drag.current?.stop();
    },
    [],
  );

  const onPointerDown = ({ button, pointerId, currentTarget: { ownerDocument } }: PointerEvent) => {
    if (button !== 0) return;
    end('commit');
    // The button may be released anywhere.
    const abort = new AbortController();
    const { signal } = abort;
    const listen = (type: 'pointerup' | 'pointercancel', how: 'commit' | 'cancel') =>
      ownerDocument.addEventListener(type, (event) => event.pointerId === pointerId && end(how), { signal, capture: true });
    listen('pointerup', 'commit');
    // the touch turned out to scroll the panel
    listen('pointercancel', 'cancel');
    drag.current = { gesture: document.begin(step), stop: () => abort.abort() };
  };
  const change = (next: number) => void document.change(step, recipe(next), { gesture: `slide ${id}` });
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === 'Escape' && drag.current !== null) {
      event.stopPropagation();
      // The pointer still holds the slider: the rest of this drag is ignored.
      drag.current.gesture.cancel();
      return;
    }
    const by = KEYS[event.key];
    const edge = event.key === 'Home' ? rule.least : event.key === 'End' ? rule.most : null;
    if ((by === undefined && edge === null) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    change(edge ?? within(rule, value + by * stepOf(rule) * (event.shiftKey ? 10 : 1)));
  };
  return (
    <input
      type="range"
      className="rule__slider"
      aria-label={label}
      aria-valuetext={`${value} ${rule.unit}`}
      aria-describedby={describedBy}
      min={0}
      max={SLIDER_END}
      step="any"
      value={positionOf(rule, value)}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
      onChange={(event) => {
        const next = valueAt(rule, Number(event.target.value));
        if (drag.current === null) change(next);
        else drag.current.gesture.set(recipe(next));
      }}
      onBlur={document.seal}
    />
  );
}
