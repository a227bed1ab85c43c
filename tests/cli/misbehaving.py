# SPDX-License-Identifier: Apache-2.0
"""An integrator that leaves the states as they are, and does one thing wrong.   usage: misbehaving.py FAULT FILE_OF_PROCESSES"""
import json, os, signal, struct, sys, time

FAULT, HEADER = sys.argv[1], struct.Struct('=4s5id')
with open(sys.argv[2], 'a') as f: f.write(f'{os.getpid()}\n')
GREETINGS = dict(banner='Loading the model ...', version='{"polhode":7,"name":"bad"}', nameless='{"polhode":1}', number='{"polhode":1,"name":"bad","takes":3}',
                 key='{"polhode":1,"name":"bad","step":1}', claim='{"polhode":1,"name":"bad","claims":{"week":1}}', order='{"polhode":1,"name":"bad","claims":{"strong_general":-2}}',
                 two='{"polhode":1,"name":"bad"}\nready', long='x' * 100000)


def say(header, data=b''):
    sys.stdout.buffer.write(HEADER.pack(*header[:5], len(data), header[6]) + data)
    sys.stdout.buffer.flush()


def sleep(): time.sleep(300)
def refuse(header, body): say(header, b'knows spins\nalone') if header[1] == 1 else keep(header, body)
def keep(header, body, paths=None): say(header, states(header, body))
def states(header, body): return body[:8 * SCENE['components'] * header[2]]


def text(header, body):
    print('step', header[3], 'done')
    keep(header, body)


def half(header, body):
    sys.stdout.buffer.write(HEADER.pack(*header[:5], len(states(header, body)), header[6]) + body[:100])
    sys.stdout.buffer.flush()
    sys.exit(3)


def partly(header, body):
    sys.stdout.buffer.write(HEADER.pack(*header[:5], len(states(header, body)), header[6]) + body[:100])
    sys.stdout.buffer.flush()
    sleep()


def raises(header, body): raise ValueError('inertia 2 is singular')
def floods(header, body): sys.stderr.write('a warning\n' * 7000), keep(header, body)


def complains(header, body):
    while True: sys.stderr.write('a warning\n' * 1000)


def grandchild(header, body):
    if os.fork() == 0:
        with open(sys.argv[2], 'a') as f: f.write(f'{os.getpid()}\n')
    sleep()


def closes(fd):
    def close(*_): os.close(fd), sleep()
    return close


def fewer(header, body):
    paths = header[2] - 1
    say((*header[:2], paths, *header[3:]), body[:8 * SCENE['components'] * paths])


STEPS = dict(text=text, half=half, partly=partly, raises=raises, floods=floods, complains=complains, grandchild=grandchild, fewer=fewer, closes_out=closes(1), refuses=refuse,
             hangs=lambda *_: sleep(), dies=lambda *_: os.kill(os.getpid(), signal.SIGSEGV), exits=lambda *_: sys.exit(3),
             short=lambda h, b: say(h, b[:8]), kind=lambda h, b: say((h[0], 5, *h[2:]), states(h, b)),
             nan=lambda h, b: say(h, struct.pack('=d', float('nan')) * (len(states(h, b)) // 8)))
if FAULT == 'silent': sleep()
if FAULT == 'gone': sys.exit('no licence')
with open(sys.argv[2]) as f:
    if FAULT == 'again' and len(f.readlines()) > 1: GREETINGS['again'] = '{"polhode":1,"name":"bad","title":"another"}'
print(GREETINGS.get(FAULT, '{"polhode":1,"name":"bad"}'), flush=True)
while head := sys.stdin.buffer.read(HEADER.size):
    header = HEADER.unpack(head)
    if FAULT == 'ahead' and header[5] > 1 << 19: say(header, bytes(8 * SCENE['components'] * header[2])), sleep()
    body = sys.stdin.buffer.read(header[5])
    if header[1] == 1: SCENE = json.loads(body)
    if header[1] == 1 and FAULT == 'talks': say(header, bytes(1 << 20))
    elif header[1] == 1 and FAULT != 'refuses': say(header)
    else: STEPS.get(FAULT, keep)(header, body)
    if FAULT in ('stops', 'closes_in'):
        if FAULT == 'closes_in': os.close(0)
        sleep()
