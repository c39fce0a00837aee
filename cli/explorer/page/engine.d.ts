// What the page uses of the engine, the program compiled to WebAssembly.

/** What a command is given: option names without "--", values as text with units. */
type Options = Record<string, string>;

interface OptionRow {
  name: string;
  help: string;
  /** All that a text may have; empty: any. */
  values: string[];
  /** Of a bare number; empty without a dimension. */
  unit: string;
  /** Whether a design takes LOW:HIGH. */
  range: boolean;
  /** The load that it gives or shapes. */
  load: "" | "hit" | "pulse" | "record";
  /** Each damper is simulated if it is given. */
  simulated: boolean;
  units: "any" | "dimensionless" | "physical";
  /** Of design, region and simulate, those that take it. */
  commands: string[];
  /** Of each set at most one may be given; 0 is none. */
  set: number;
}

interface Figure {
  id: string;
  title: string;
  caption: string;
  svg: string;
}

interface Answer {
  /** The program's exit code: 0, or 3 if no damper is admissible. */
  exit: number;
  /** The JSON report, as text and read; empty and null where none is asked for. */
  json: string;
  report: any;
  /** Values that are absurd together, each with what may have been meant. */
  doubts: string[];
  figures: Figure[];
  /** A quick design that would simulate dampers, and is not made. */
  searches?: boolean;
  /** The specification as HTML if it is asked for; null without an admissible damper. */
  sheet?: string | null;
}

/** The ids of the figures to draw; whether a report is wanted (the default); title and scene of a specification; whether
 * a design may only say that it searches. */
interface Ask {
  figures?: string[];
  report?: boolean;
  sheet?: { title: string; scene: string };
  quick?: boolean;
}

/** Wrong input: the program's one line. */
interface Refusal {
  error: string;
}

/** Dimensionless, from the start to the end of the motion. */
interface Motion {
  t: Float64Array;
  x: Float64Array;
  v: Float64Array;
}

interface Batch {
  peak: Float64Array;
  rest: Float64Array;
  outcome: Uint8Array;
}

interface Engine {
  version: string;
  options: OptionRow[];
  /** The style sheet of its figures and its specification. */
  style: string;
  outcomes: string[];
  run(
    command: string,
    options: Options,
    ask?: Ask,
    files?: Record<string, Uint8Array>,
  ): Answer | Refusal;
  motion(options: Options, points: number): Motion | Refusal;
  batch(options: Options, f: Float64Array, delta: Float64Array, v0: Float64Array): Batch | Refusal;
}

/** The part of Emscripten's module that engine.js needs. */
interface Module {
  HEAPF64: Float64Array;
  FS: {
    mkdir(name: string): void;
    chdir(name: string): void;
    writeFile(name: string, content: Uint8Array): void;
    unlink(name: string): void;
  };
  UTF8ToString(at: number): string;
  stringToUTF8(text: string, at: number, size: number): void;
  lengthBytesUTF8(text: string): number;
  _malloc(size: number): number;
  _free(at: number): void;
  _stillpoint_about(): number;
  _stillpoint_run(request: number): number;
  _stillpoint_motion(options: number, points: number): number;
  _stillpoint_batch(options: number, size: number, columns: number): number;
  _stillpoint_numbers(): number;
  _stillpoint_count(): number;
}

declare function createModule(settings: {
  wasmBinary: Uint8Array;
  progress?: (words: string) => void;
}): Promise<Module>;

/** Of Emscripten's compiler, which reads left_out.js. */
declare const LibraryManager: { library: Record<string, unknown> };
declare function mergeInto(library: Record<string, unknown>, more: Record<string, string>): void;

/** The files of data/scenes by their names. */
declare const scenes: Record<string, Record<string, string | number | Array<string | number>>>;

/** Those of the program's options that the page takes. */
declare const option_rows: OptionRow[];

/** Of the engine, unpacked by loader.js: its module, and the scripts around it. */
declare var stillpointWasm: Uint8Array;
declare var stillpointEngine: string;
