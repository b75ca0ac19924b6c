import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { quote } from '../../schema/basics/words.ts';
import { OBJECT_LISTS, readLevel } from '../../schema/index.ts';
import { explainMistake } from '../../schema/json/mistakes.ts';
import { scanJson } from '../../schema/json/scan.ts';

// The hint for each problem, and its place.

function failureIn(text: string) {
  const { failure } = scanJson(text);
  return failure === null ? null : explainMistake(text, failure);
}

const END = 'found the end of the file';
const VALUE = 'expected a value';
const ENTRY = 'expected a value or "]"';
const KEY = 'expected a key in double quotes';
const FIRST_KEY = 'expected a key in double quotes or "}"';

/** Invalid JSON, by hint: the text, the offset of the marked place, and the message. */
const FAILURES: Readonly<Record<string, readonly (readonly [source: string, offset: number, message: string])[]>> = {
  'Add what is missing, or take the file from git again.': [
    ['{"a":"\\u12', 10, `expected the closing " of the text, ${END}`],
    ['{"a":"\\u', 8, `expected the closing " of the text, ${END}`],
    ['["a', 3, `expected the closing " of the text, ${END}`],
    ['["a\\', 4, `expected the closing " of the text, ${END}`],
    ['[-', 2, `expected the digits of a number, ${END}`],
    ['[1.', 3, `expected a digit after the point, ${END}`],
    ['[1e', 3, `expected the digits of an exponent, ${END}`],
    ['[1e+', 4, `expected the digits of an exponent, ${END}`],
    ['{"a":{', 6, `${FIRST_KEY}, ${END}`],
    ['{"a"', 4, `expected a colon after the key, ${END}`],
    ['{"a":', 5, `${VALUE}, ${END}`],
    ['{"a":1', 6, `expected "," or "}", ${END}`],
    ['{"a":1,', 7, `${KEY}, ${END}`],
    ['[', 1, `${ENTRY}, ${END}`],
    ['[1', 2, `expected "," or "]", ${END}`],
    ['[1,', 3, `${VALUE}, ${END}`],
  ],
  'Remove it: a number is written without a unit.': [
    ['{"radius": 620 px}', 15, 'expected "," or "}", found "px"'],
    ['[620px]', 4, 'expected "," or "]", found "px"'],
    ['[1 yes]', 3, 'expected "," or "]", found "yes"'],
  ],
  'Write \\" for a quote within a text.': [['["the "big" one"]', 7, 'expected "," or "]", found "big"']],
  'Add a comma before it, if one is missing, and put it in double quotes.': [
    ['{"a":1\nb:2}', 7, 'expected "," or "}", found "b"'],
    ['[[] b]', 4, 'expected "," or "]", found "b"'],
  ],
  'Add a comma before it, if one is missing.': [
    ['[1 true]', 3, 'expected "," or "]", found "true"'],
    ['[1 "a"]', 3, 'expected "," or "]", found "a"'],
    ['{"a":1\n"black\\u0048ole":{}}', 7, 'expected "," or "}", found "blackHole"'],
    ['[1 "a\nb"]', 3, 'expected "," or "]", found "a"'],
    ['[1 "\\x"]', 3, 'expected "," or "]", found "\\\\x"'],
    [`[1 "${'a'.repeat(50)}"]`, 3, `expected "," or "]", found "${'a'.repeat(40)}…"`],
    ['[1 :]', 3, 'expected "," or "]", found ":"'],
    ['[1 2]', 3, 'expected "," or "]", found "2"'],
    ['[1 -2]', 3, 'expected "," or "]", found "-"'],
    ['[1 +1]', 3, 'expected "," or "]", found "+"'],
    ['[1 .5]', 3, 'expected "," or "]", found "."'],
    ['[1.5.5]', 4, 'expected "," or "]", found "."'],
    ['{"a":1 @', 7, 'expected "," or "}", found "@"'],
  ],
  'Put the key in double quotes.': [
    ['{1:2}', 1, `${FIRST_KEY}, found a number`],
    ['{.5:1}', 1, `${FIRST_KEY}, found a number`],
    ['{+1:2}', 1, `${FIRST_KEY}, found a number`],
    ['{"a":1,2:3}', 7, `${KEY}, found a number`],
  ],
  'Put the key in double quotes: "yes".': [
    ['{yes:1}', 1, `${FIRST_KEY}, found "yes" without quotes`],
    ['{"a":1,yes:2}', 7, `${KEY}, found "yes" without quotes`],
  ],
  'Write a colon between the key and its value.': [
    ['{"a" 1}', 5, 'expected a colon after the key, found "1"'],
    ['{"a"=1}', 4, 'expected a colon after the key, found "="'],
  ],
  'Remove what follows the last bracket.': [
    ['{"a":1} x', 8, 'expected the end of the file, found "x"'],
    ['{"a":1}"', 7, 'expected the end of the file, found "\\""'],
    ['{"a":1}2', 7, 'expected the end of the file, found "2"'],
  ],
  'Write the character itself.': [
    ['{"a":"\\u12g4"}', 6, 'expected 4 hexadecimal digits after \\u, found "12g4"'],
    ['["\\u00"]', 2, 'expected 4 hexadecimal digits after \\u, found "00\\"]"'],
  ],
  'Write \\\\ for a backslash.': [['{"a":"\\q"}', 6, 'JSON has no escape \\q']],
  'Close it, or write \\n for a new line in it.': [
    ['{"a":"b\nc"}', 5, 'the text has no closing " on its line'],
    ['{"a":"b\rc"}', 5, 'the text has no closing " on its line'],
  ],
  'Write \\t.': [['{"a":"b\tc"}', 7, 'a text can\'t contain the control character "\\t"']],
  'Remove it.': [
    ['{"a":"b\u0001c"}', 7, 'a text can\'t contain the control character "\\u0001"'],
    ['["\u001f"]', 2, 'a text can\'t contain the control character "\\u001f"'],
    ['["\u000b"]', 2, 'a text can\'t contain the control character "\\u000b"'],
  ],
  'Write the digits of the number.': [
    ['[-x', 2, 'expected a digit after the minus, found "x"'],
    ['[-a]', 2, 'expected a digit after the minus, found "a"'],
  ],
  'Write a number.': [
    ['[-Infinity]', 1, 'expected a number, found -Infinity: JSON has no such value'],
    ['[+Infinity]', 1, `${ENTRY}, found +Infinity: JSON has no such value`],
    ['[NaN]', 1, `${ENTRY}, found NaN: JSON has no such value`],
    ['{"a":Infinity}', 5, `${VALUE}, found Infinity: JSON has no such value`],
  ],
  'Remove the +.': [
    ['[+1]', 1, 'a number can\'t begin with "+"'],
    ['{"a":+1}', 5, 'a number can\'t begin with "+"'],
  ],
  'Write 0 before the point.': [
    ['[.5]', 1, 'a number can\'t begin with "."'],
    ['{"a":.5}', 5, 'a number can\'t begin with "."'],
  ],
  'Remove the zeros at its beginning.': [
    ['[01]', 1, "a number can't begin with 0 before other digits"],
    ['[-01]', 1, "a number can't begin with 0 before other digits"],
  ],
  'Write the number in decimal.': [
    ['[0x1]', 1, 'JSON has no hexadecimal numbers'],
    ['[0X1]', 1, 'JSON has no hexadecimal numbers'],
  ],
  'Remove the point, or write 0 after it.': [['[1.x]', 3, 'expected a digit after the point, found "x"']],
  'Write digits after the e, or remove it.': [
    ['[1ex]', 3, 'expected the digits of an exponent, found "x"'],
    ['[1E+x]', 4, 'expected the digits of an exponent, found "x"'],
    ['[1e-]', 4, 'expected the digits of an exponent, found "]"'],
  ],
  'Write a number of at most 1.79e308.': [
    ['[1e999]', 1, 'the number 1e999 is too large for a double'],
    ['[-1E309]', 1, 'the number -1E309 is too large for a double'],
    [`[${'9'.repeat(310)}]`, 1, `the number ${'9'.repeat(40)}… is too large for a double`],
  ],
  'Write null.': [
    ['[Nul]', 1, `${ENTRY}, found "Nul" without quotes`],
    ['{"a":nul}', 5, `${VALUE}, found "nul" without quotes`],
  ],
  'Write true.': [['[True]', 1, `${ENTRY}, found "True" without quotes`]],
  'Put texts in double quotes; leave out keys without a value.': [
    ['[yes]', 1, `${ENTRY}, found "yes" without quotes`],
    ['{"a":yes}', 5, `${VALUE}, found "yes" without quotes`],
    ['[NaNa]', 1, `${ENTRY}, found "NaNa" without quotes`],
  ],
  'Remove the comma.': [
    ['[1,]', 2, `${VALUE} after the comma, found "]"`],
    ['[1 , \n]', 3, `${VALUE} after the comma, found "]"`],
    ['{"a":1,}', 6, `${KEY} after the comma, found "}"`],
  ],
  'Check that every bracket has its partner.': [
    ['{"a":}', 5, `${VALUE}, found "}"`],
    ['[}', 1, `${ENTRY}, found "}"`],
    ['{]', 1, `${FIRST_KEY}, found "]"`],
    ['[1}', 2, 'expected "," or "]", found "}"'],
    ['{"a":1]', 6, 'expected "," or "}", found "]"'],
    ['}', 0, `${VALUE}, found "}"`],
    ['[1]]', 3, 'expected the end of the file, found "]"'],
  ],
  'Use straight double quotes.': [
    ["['a']", 1, `${ENTRY}, found the quote ': JSON has only "`],
    ['{‘a’:1}', 1, `${FIRST_KEY}, found the quote ‘: JSON has only "`],
  ],
  'Move it into "description", or into a key of your own that begins with x-, such as "x-note".': [
    ['# x', 0, `${VALUE}, found a comment: JSON has none`],
    ['[1 // x\n]', 3, 'expected "," or "]", found a comment: JSON has none'],
    ['/* x */', 0, `${VALUE}, found a comment: JSON has none`],
  ],
  'Correct the marked place.': [
    ['[/]', 1, `${ENTRY}, found "/"`],
    ['[@]', 1, `${ENTRY}, found "@"`],
    ['{@', 1, `${FIRST_KEY}, found "@"`],
    ['{-1:2}', 1, `${FIRST_KEY}, found "-"`],
  ],
  'A level needs 4 levels of brackets: remove the others.': [
    ['['.repeat(65), 64, 'brackets are nested more than 64 deep'],
    [`${'{"a":'.repeat(64)}{}`, 320, 'brackets are nested more than 64 deep'],
  ],
};

describe('a text that is not JSON', () => {
  for (const [hint, cases] of Object.entries(FAILURES)) {
    test(hint, () => {
      for (const [source, offset, message] of cases)
        expect(failureIn(source)).toMatchObject({ offset, message, hint, path: [], part: 'value' });
    });
  }

  test('is reported to end before its trailing space', () => {
    fc.assert(
      fc.property(fc.array(fc.constantFrom(' ', '\n', '\r', '\t')), (space) => {
        expect(failureIn(`[1,${space.join('')}`)).toMatchObject({ code: 'truncated-json', offset: 3 });
      }),
    );
  });

  test('is reported with the complete unquoted word at the place', () => {
    const letter = fc.constantFrom(...'AZMazm_$ü09');
    fc.assert(
      fc.property(
        fc.constantFrom(...'AZaz_$ü'),
        fc.array(letter),
        fc.constantFrom('', ' ', '-', '@', ']'),
        (first, more, then) => {
          const word = `q${first}${more.join('')}`;
          expect(failureIn(`{${word}${then}`)).toMatchObject({
            message: `${FIRST_KEY}, found ${quote(word)} without quotes`,
            hint: `Put the key in double quotes: ${quote(word)}.`,
          });
        },
      ),
    );
  });

  test('may have extra keys that begin with x-', () => {
    const key = fc.constantFrom('x-', 'x-a', 'x', 'a-', 'xx-', '-x-', 'X-a', '', 'x_a', '\u0078-', 'x\\u002da');
    fc.assert(
      fc.property(fc.array(key), (keys) => {
        const { hasExtensions } = scanJson(`[{${keys.map((name) => `"${name}":[{}]`).join()}}]`);
        expect(hasExtensions).toBe(keys.some((name) => name.startsWith('x-') || name === 'x\\u002da'));
      }),
    );
  });

  test('may have numbers of any length that fit into a double', () => {
    for (const number of ['1e308', '-1.7976931348623157e308', '1E-999', '9'.repeat(308), `0.${'0'.repeat(400)}1`])
      expect(failureIn(`[${number}]`)).toBeNull();
  });
});

const small = (rest: string) => `{"version":1,"name":"a","astronaut":{"x":1,"y":2},"blackHole":{"x":1,"y":3}${rest}}`;
const nova = (rest: string) => small(`,"novae":[{"x":1,"y":2,"radius":3${rest}}]`);
const hold = (text: string) => small(`,"runs":[{"name":"a","holds":[${text}]}]`);
const TOP = `$schema, version, conflicts, name, description, astronaut, blackHole, range, recoil, rules, allow, ${OBJECT_LISTS.join(', ')}, runs`;

/** Invalid levels, by hint: the text and the message. */
const PROBLEMS: Readonly<Record<string, readonly (readonly [source: string, message: string])[]>> = {
  'Remove the quotes.': [
    [small(',"range":"7"'), 'range: expected a number, found the text "7"'],
    [small(',"range":"-7.5"'), 'range: expected a number, found the text "-7.5"'],
    [hold('["1",2]'), 'run "a", hold 1, press: expected a number, found the text "1"'],
    [small(',"recoil":"true"'), 'recoil: expected true or false, found the text "true"'],
    [small(',"recoil":"false"'), 'recoil: expected true or false, found the text "false"'],
  ],
  'Write a number.': [
    [small(',"range":"7px"'), 'range: expected a number, found the text "7px"'],
    [small(',"range":"7."'), 'range: expected a number, found the text "7."'],
    [small(',"range":[7]'), 'range: expected a number, found a list of 1'],
    [small(',"range":"true"'), 'range: expected a number, found the text "true"'],
  ],
  'Write true or false.': [
    [small(',"recoil":"yes"'), 'recoil: expected true or false, found the text "yes"'],
    [small(',"recoil":"7"'), 'recoil: expected true or false, found the text "7"'],
    [small(',"recoil":1'), 'recoil: expected true or false, found the number 1'],
  ],
  'Write a text in double quotes.': [
    [small(',"description":12'), 'description: expected a text in double quotes, found the number 12'],
    [small(',"description":true'), 'description: expected a text in double quotes, found true'],
  ],
  'Write a list in [ ].': [
    [small(',"runs":7'), 'runs: expected a list in [ ], found the number 7'],
    [small(',"novae":{}'), 'novae: expected a list in [ ], found an object'],
  ],
  'Write an object in { }.': [
    [small(',"novae":[7]'), 'nova 1: expected an object in { }, found the number 7'],
    [small(',"novae":[[]]'), 'nova 1: expected an object in { }, found an empty list'],
    [small(',"runs":[null]'), 'run 1: expected an object in { }, found null'],
    [small('').replace('{"x":1,"y":2}', '7'), 'astronaut: expected an object in { }, found the number 7'],
  ],
  'Write a pair [press, release].': [
    [hold('[1,2,3]'), 'run "a", hold 1: expected a pair [press, release], found a list of 3'],
    [hold('[1]'), 'run "a", hold 1: expected a pair [press, release], found a list of 1'],
    [hold('{}'), 'run "a", hold 1: expected a pair [press, release], found an object'],
  ],
  'Write 3.': [[hold('[1,2.5]'), 'run "a", hold 1, release: expected a whole number, found 2.5']],
  'Write 2.': [[hold('[2.4,9]'), 'run "a", hold 1, press: expected a whole number, found 2.4']],
  'Write [2, 5].': [[hold('[5,2]'), 'run "a", hold 1: [5, 2] is reversed: the release must come after the press']],
  'Remove it, or release later.': [
    [hold('[5,5]'), 'run "a", hold 1: [5, 5] never holds the gun: the release must come after the press'],
  ],
  'Write "astronaut"; gq import reads files of the original game.': [
    [small(',"player":1'), 'unknown key "player": did you mean "astronaut"?'],
  ],
  'Write "hot"; gq import reads files of the original game.': [
    [small(',"asteroids":[{"x":1,"y":2,"radius":3,"enemy":true}]'), 'unknown key "enemy" in asteroid 1: did you mean "hot"?'],
  ],
  'Write "range", or begin a key of your own with x-.': [[small(',"rnage":1'), 'unknown key "rnage": did you mean "range"?']],
  'Write "holds", or begin a key of your own with x-.': [
    [small(',"runs":[{"name":"a","holds":[],"hold":1}]'), 'unknown key "hold" in run "a": did you mean "holds"?'],
  ],
  [`Known keys are ${TOP}. Keys of your own begin with x-.`]: [
    [small(',"gravity":1'), 'unknown key "gravity"'],
    // a name of the original, but for something else
    [small(',"enemy":1'), 'unknown key "enemy"'],
    [small(',"toString":1'), 'unknown key "toString"'],
  ],
  'Known keys are id, x, y, radius. Keys of your own begin with x-.': [
    [nova(',"a b":1'), 'unknown key "a b" in nova 1'],
    [nova(',"player":1'), 'unknown key "player" in nova 1'],
  ],
  'Keep one of them, without the list around it: "astronaut": { "x": 0, "y": 0 }.': [
    [
      small('').replace('{"x":1,"y":2}', '[{"x":1,"y":2},{"x":1,"y":2}]'),
      'astronaut: a level has exactly one astronaut, found a list of 2',
    ],
  ],
  'Keep one of them, without the list around it: "blackHole": { "x": 0, "y": 0 }.': [
    [small('').replace('{"x":1,"y":3}', '[]'), 'black hole: a level has exactly one black hole, found an empty list'],
  ],
  'A level is one object in { }; gq import reads the list of levels of the original game.': [
    ['[]', 'expected a level (an object in { }), found an empty list'],
    ['7', 'expected a level (an object in { }), found the number 7'],
    ['null', 'expected a level (an object in { }), found null'],
  ],
  'Write a number of at least 0.001.': [[small(',"range":0'), 'range: expected a number of at least 0.001, found 0']],
  'Write a number of at most 1000000.': [[small(',"range":1e7'), 'range: expected a number of at most 1000000, found 10000000']],
  'Write a name.': [[small('').replace('"a"', '""'), 'name: expected a name, found an empty text']],
  'Shorten it.': [[small('').replace('"a"', `"${'a'.repeat(121)}"`), 'name: expected at most 120 characters, found 121']],
  'Add "radius".': [[small(',"novae":[{"x":1,"y":2}]'), 'the key "radius" is missing in nova 1']],
  'Add "name".': [[small('').replace('"name":"a",', ''), 'the key "name" is missing']],
  'Add "version": 1 as the first key.': [[small('').replace('"version":1,', ''), 'the key "version" is missing']],
  'Write "version": 1.': [
    [small('').replace('1', '0.5'), 'version: expected 1, the version of the format, found the number 0.5'],
    [small('').replace('1', '1.5'), 'version: expected 1, the version of the format, found the number 1.5'],
    [small('').replace('1', '-1'), 'version: expected 1, the version of the format, found the number -1'],
    [small('').replace('1', '"1"'), 'version: expected 1, the version of the format, found the text "1"'],
    [small('').replace('1', '0'), 'version: the format has no version 0'],
  ],
  'Update the toolkit (gravity-quest-toolkit).': [
    [small('').replace('1', '2'), 'version: this file uses version 2 of the format; this toolkit reads versions up to 1'],
  ],
  'Correct it, or remove it: gq fmt writes a new one.': [
    [nova(',"id":"A"'), 'nova 1, id: expected 2 to 16 of the characters a-z and 0-9, found the text "A"'],
  ],
  'Remove it here: gq fmt writes a new one.': [
    [nova(',"id":"aa"},{"id":"aa","x":1,"y":2,"radius":3'), 'nova 2, id: the id "aa" already belongs to nova 1'],
    [
      small(',"novae":[{"id":"aa","x":1,"y":2,"radius":3}],"aliens":[{"x":1,"y":2},{"id":"aa","x":1,"y":2}]'),
      'alien 2, id: the id "aa" already belongs to nova 1',
    ],
  ],
  'Rename one of the two.': [
    [
      small(',"runs":[{"name":"b","holds":[]},{"name":"a","holds":[]},{"name":"a","holds":[]}]'),
      'run 3, name: the name "a" already belongs to run 2',
    ],
  ],
};

describe('a text that is not a level', () => {
  for (const [hint, cases] of Object.entries(PROBLEMS)) {
    test(hint.replaceAll('$', ''), () => {
      for (const [source, message] of cases) {
        const reading = readLevel(source);
        expect(reading.ok || reading.problems.map((problem) => [problem.message, problem.hint])).toEqual([[message, hint]]);
      }
    });
  }

  test('has one problem for each value, and no extra one for a misspelt key', () => {
    const of = (source: string) => {
      const reading = readLevel(source);
      return reading.ok ? [] : reading.problems.map(({ code, pointer }) => `${code} ${pointer}`);
    };
    expect(of(small('').replace('astronaut', 'astronuat'))).toEqual(['unknown-key /astronuat']);
    expect(of(small(',"novae":[{"x":1,"y":2,"raduis":3}]'))).toEqual(['unknown-key /novae/0/raduis']);
    expect(of(small(',"novae":[{"x":1,"y":2,"raduis":3},{"x":1,"y":2}]'))).toEqual([
      'unknown-key /novae/0/raduis',
      'missing-key /novae/1',
    ]);
    expect(of(nova(',"id":"A B"'))).toEqual(['bad-id /novae/0/id']);
    expect(of(small(',"player":1').replace('"astronaut":{"x":1,"y":2},', ''))).toEqual(['unknown-key /player']);
    // a key that is misspelt in one place is missing in another
    expect(of(small(',"zzz":1').replace('"astronaut":{"x":1,"y":2},', ''))).toEqual(['missing-key ', 'unknown-key /zzz']);
  });
});
