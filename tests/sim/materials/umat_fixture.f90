! SPDX-License-Identifier: GPL-3.0-or-later
! A small UMAT for the tests: linear elasticity with a Drucker-Prager yield surface, perfectly
! plastic, returned in closed form (tension positive, p = tr(stress)/3):
!
!   f = q + M p - c <= 0,   flow potential q + N p
!
! PROPS: bulk modulus, shear modulus, M, N, c, misbehaviour (below; 0: none).
! STATEV: 1 void ratio, 2 number of plastic increments, 3-4 SINV, 5-7 SPRINC, 8-9 stress 11 and 12
! after ROTSIG by 30 degrees about axis 3, 10 TIME, 11 KINC, 12 first direction of SPRIND.
subroutine umat(stress, statev, ddsdde, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, &
    time, dtime, temp, dtemp, predef, dpred, cmname, ndi, nshr, ntens, nstatv, props, nprops, &
    coords, drot, pnewdt, celent, dfgrd0, dfgrd1, noel, npt, layer, kspt, kstep, kinc)
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic
  implicit none
  integer :: ndi, nshr, ntens, nstatv, nprops, noel, npt, layer, kspt, kstep, kinc
  character(len=80) :: cmname
  double precision :: stress(ntens), statev(nstatv), ddsdde(ntens, ntens), sse, spd, scd, rpl, &
    ddsddt(ntens), drplde(ntens), drpldt, stran(ntens), dstran(ntens), time(2), dtime, temp, &
    dtemp, predef(1), dpred(1), props(nprops), coords(3), drot(3, 3), pnewdt, celent, &
    dfgrd0(3, 3), dfgrd1(3, 3)
  double precision :: bulk, shear, m, n, c, p, q, f, multiplier, hardening, keep, s(6), unit(6), &
    normal(6), trace, turn(3, 3), principal(3), directions(3, 3), turned(6)
  double precision, parameter :: delta(6) = [1d0, 1d0, 1d0, 0d0, 0d0, 0d0]
  integer :: i, misbehaviour
  logical, save :: was_slow = .false.
  integer, save :: times = 0
  interface
    integer(c_int) function rest(microseconds) bind(c, name='usleep')
      import :: c_int
      integer(c_int), value :: microseconds
    end function rest
    integer(c_int) function raise_signal(number) bind(c, name='raise')
      import :: c_int
      integer(c_int), value :: number
    end function raise_signal
    integer(c_int) function close_file(number) bind(c, name='close')
      import :: c_int
      integer(c_int), value :: number
    end function close_file
    integer(c_int) function copy_file(from, onto) bind(c, name='dup2')
      import :: c_int
      integer(c_int), value :: from, onto
    end function copy_file
    integer(c_int) function parent() bind(c, name='getppid')
      import :: c_int
    end function parent
    integer(c_int) function tell(process, number) bind(c, name='kill')
      import :: c_int
      integer(c_int), value :: process, number
    end function tell
    integer(c_int) function of_file(file, request, with) bind(c, name='fcntl')
      import :: c_int
      integer(c_int), value :: file, request, with
    end function of_file
    integer(c_int) function of_device(file, request, with) bind(c, name='ioctl')
      import :: c_int, c_long
      integer(c_int), value :: file
      integer(c_long), value :: request
      integer(c_int) :: with
    end function of_device
    integer(c_int) function limits_of(process, which, new, old) bind(c, name='prlimit')
      import :: c_int, c_ptr
      integer(c_int), value :: process, which
      type(c_ptr), value :: new, old
    end function limits_of
    integer(c_int) function new_process() bind(c, name='fork')
      import :: c_int
    end function new_process
    integer(c_int) function new_session() bind(c, name='setsid')
      import :: c_int
    end function new_session
    subroutine give_up() bind(c, name='abort')
    end subroutine give_up
    subroutine jump(to, with) bind(c, name='longjmp')
      import :: c_int, c_intptr_t
      integer(c_intptr_t) :: to(64)
      integer(c_int), value :: with
    end subroutine jump
    type(c_ptr) function ignore(number, handler) bind(c, name='signal')
      import :: c_int, c_intptr_t, c_ptr
      integer(c_int), value :: number
      integer(c_intptr_t), value :: handler
    end function ignore
  end interface

  bulk = props(1); shear = props(2); m = props(3); n = props(4); c = props(5)
  misbehaviour = nint(props(6))
  if (any(dstran /= 0d0)) call misbehave(misbehaviour)

  trace = sum(dstran(1:3))
  do i = 1, 3
    stress(i) = stress(i) + bulk * trace + 2 * shear * (dstran(i) - trace / 3)
  end do
  stress(4:6) = stress(4:6) + shear * dstran(4:6)
  ddsdde = 0
  do i = 1, 6
    ddsdde(i, i) = merge(2 * shear, shear, i <= 3)
  end do
  ddsdde(1:3, 1:3) = ddsdde(1:3, 1:3) + bulk - 2 * shear / 3

  call sinv(stress, p, q, ndi, nshr)
  f = q + m * p - c
  if (f > 0 .and. q > 0) then
    s = stress - p * delta
    unit = s / (q * sqrt(2d0 / 3))
    hardening = 3 * shear + m * bulk * n
    multiplier = f / hardening
    keep = 1 - 3 * shear * multiplier / q
    stress = s * keep + (p - bulk * n * multiplier) * delta
    normal = sqrt(6d0) * shear * unit + m * bulk * delta
    ddsdde = 0
    do i = 1, 6
      ddsdde(i, i) = keep * merge(2 * shear, shear, i <= 3)
    end do
    ddsdde(1:3, 1:3) = ddsdde(1:3, 1:3) + bulk - 2 * shear * keep / 3
    do i = 1, 6
      ddsdde(:, i) = ddsdde(:, i) - (sqrt(6d0) * shear * unit + bulk * n * delta) * normal(i) &
        / hardening + 6 * shear**2 * multiplier / q * unit * unit(i)
    end do
    statev(2) = statev(2) + 1
  end if

  statev(1) = statev(1) + (1 + statev(1)) * trace
  call sinv(stress, statev(3), statev(4), ndi, nshr)
  call sprinc(stress, principal, 1, ndi, nshr)
  statev(5:7) = principal
  turn = 0
  turn(1, 1) = cos(acos(-1d0) / 6); turn(2, 2) = turn(1, 1); turn(3, 3) = 1
  turn(1, 2) = sin(acos(-1d0) / 6); turn(2, 1) = -turn(1, 2)
  call rotsig(stress, turn, turned, 1, ndi, nshr)
  statev(8) = turned(1); statev(9) = turned(4)
  statev(10) = time(2); statev(11) = kinc
  call sprind(stress, principal, directions, 1, ndi, nshr)
  statev(12) = abs(directions(1, 1))
  if (all(dstran == 0d0)) return
  if (misbehaviour == 4) stress(1) = ieee_value(1d0, ieee_quiet_nan)
  if (misbehaviour == 8) ddsdde = 0
  if (misbehaviour == 9) ddsdde(2, 1) = ieee_value(1d0, ieee_positive_inf)
  if (misbehaviour == 10) statev(3) = ieee_value(1d0, ieee_quiet_nan)
  if (misbehaviour == 11) stress(2) = stress(2) * 1.01d0
  ! Indices out of range: one past the end, one before the start, and 300 beyond.
  if (misbehaviour == 14) statev(nstatv + 1) = 1
  if (misbehaviour == 15) stress(misbehaviour - 15) = 1
  if (misbehaviour == 16) ddsdde(1, misbehaviour - 9) = 1
  if (misbehaviour == 17) statev(2) = props(nprops + 1)
  if (misbehaviour == 18) statev(nstatv + 300) = 1
  if (misbehaviour == 33) props(nprops + 1) = 1
  if (misbehaviour == 34) props(misbehaviour - 34) = 1
  if (misbehaviour == 35) ddsdde(misbehaviour - 35, 1) = 1
  if (misbehaviour == 36) stress(ntens + 1) = 1
  if (misbehaviour == 37) then ! what are inputs
    props = 0; dstran = 7; stran = 7; time = 7; dtime = 7; ndi = 7; nshr = 7; ntens = 7; nstatv = 7
    nprops = 7; cmname = 'x'; drot = 7; dfgrd0 = 7; kinc = 7
  end if
  if (misbehaviour == 21) statev(misbehaviour - 21) = 1
  if (misbehaviour == 22) statev(2) = tell(parent(), 0)
  if (misbehaviour == 23) statev(2) = new_process()
  if (misbehaviour == 24) statev(2) = new_session()
  if (misbehaviour == 42) statev(2) = of_file(0, 8, parent()) ! F_SETOWN
  if (misbehaviour == 43) statev(2) = of_file(0, 10, 9) ! F_SETSIG, SIGKILL
  if (misbehaviour == 44) statev(2) = of_device(1, int(z'8901', c_long), parent()) ! FIOSETOWN
  if (misbehaviour == 45) statev(2) = limits_of(parent(), 0, c_null_ptr, c_null_ptr)
  if (misbehaviour == 46) statev(2) = looks_into('mem')
  if (misbehaviour == 47) statev(2) = looks_into('maps')
  if (misbehaviour == 25) statev(2) = room_for(256)

contains

  subroutine misbehave(kind)
    integer, intent(in) :: kind
    integer, pointer :: nowhere
    double precision, volatile :: turns
    integer :: integers(1)
    integer(c_int) :: ignored
    integer(c_intptr_t) :: nowhere_to(64)
    integer :: unit_number, status
    double precision :: reals(1)
    character(len=8) :: texts(1)
    double precision :: since, now
    type(c_ptr) :: nobody
    select case (kind)
    case (1)
      call c_f_pointer(c_null_ptr, nowhere)
      nowhere = 1
    case (48)
      times = times + 1
      if (times > 400) then
        call c_f_pointer(c_null_ptr, nowhere)
        nowhere = 1
      end if
    case (2)
      stop 'the cone is upside down'
    case (3)
      call xit
    case (5)
      do
        turns = turns + 1
      end do
    case (6, 12)
      integers = noel; reals = props(3); texts = cmname(1:8)
      call stdb_abqerr(merge(-3, -2, kind == 6), 'element %I of %S: M = %R', integers, reals, texts)
    case (7)
      if (maxval(abs(dstran)) > 2d-4) pnewdt = 0.25d0
    case (13)
      write (*, *) 'a word on every call'
    case (27)
      do
        ignored = rest(1000000_c_int)
      end do
    case (28)
      ignored = rest(900000_c_int)
    case (29)
      if (.not. was_slow) ignored = rest(900000_c_int)
      was_slow = .true.
    case (30)
      ignored = raise_signal(19_c_int) ! SIGSTOP
    case (38)
      nowhere_to = 0
      call jump(nowhere_to, 1_c_int)
    case (39)
      call give_up()
    case (40)
      call take_all(1)
    case (41)
      do i = 100, 3000
        open (newunit=unit_number, file='/dev/null', iostat=status)
        if (status /= 0) exit
      end do
    case (26, 31, 32)
      do i = 1, 64
        nobody = ignore(i, 1_c_intptr_t)
      end do
      do i = 0, 1023
        if (kind == 31) ignored = close_file(int(i, c_int))
        if (kind == 32) ignored = copy_file(0_c_int, int(i, c_int))
      end do
      call cpu_time(since)
      now = since
      do while (now < since + 8)
        call cpu_time(now)
      end do
    end select
  end subroutine misbehave

  !> Takes 16 megabytes at a time, writes to them, and never gives them back.
  recursive subroutine take_all(times)
    integer, intent(in) :: times
    double precision, pointer :: more(:)
    allocate (more(2097152))
    more = times
    call take_all(times + 1)
  end subroutine take_all

  !> -1 if the file of triax in /proc cannot be opened and read, else 0.
  integer function looks_into(what)
    character(len=*), intent(in) :: what
    character(len=40) :: path
    character :: byte
    integer :: number, status
    write (path, '(a,i0,2a)') '/proc/', parent(), '/', what
    open (newunit=number, file=path, access='stream', action='read', iostat=status)
    looks_into = merge(0, -1, status == 0)
    if (status /= 0 .or. what == 'mem') return
    read (number, iostat=status) byte
    looks_into = merge(0, -1, status == 0)
  end function looks_into

  !> 1 if so many megabytes can be had, else 0.
  integer function room_for(megabytes)
    integer, intent(in) :: megabytes
    double precision, allocatable :: much(:)
    integer :: refused
    allocate (much(megabytes * 131072), stat=refused)
    room_for = merge(1, 0, refused == 0)
    if (refused == 0) deallocate (much)
  end function room_for
end subroutine umat
