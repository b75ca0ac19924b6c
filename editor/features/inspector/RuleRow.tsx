import { RotateCcw } from 'lucide-react';
import { memo, useCallback, useId } from 'react';
import { RULES } from '../../../schema/index.ts';
import { useLevel } from '../../core/context/index.ts';
import { setRule } from '../../core/document/index.ts';
import { Button, NumberField } from '../../core/ui/index.ts';
import { RuleSlider } from './RuleSlider.tsx';
import { stepOf } from './rule-scale.ts';
import { originOf, type RuleValue, ruleLabel } from './rule-values.ts';

/** A rule of the level: a slider, a number field and a reset button. */
export const RuleRow = memo(function RuleRow({ name, value, isOwn, fallback, from }: RuleValue) {
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
